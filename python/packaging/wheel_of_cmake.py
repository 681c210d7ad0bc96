"""Builds the wheel of the Python package with CMake, for pip and other tools (PEP 517).

It needs what the C++ build needs (packages.txt), pybind11 and the headers of Python, all from Debian, and no other Python
package. The build folder is build/wheel; `--config-settings=build-dir=FOLDER` names another one, such as one that CMake
has configured already.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
NAME = "af2"
SUMMARY = "Advancing front surface meshing driven by rules"


def version():
    """As CMake has it."""
    text = (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^project\(af2 VERSION ([0-9.]+)", text, re.M).group(1)


def metadata():
    readme = (SOURCE / "README.md").read_text(encoding="utf-8")
    return (f"Metadata-Version: 2.1\nName: {NAME}\nVersion: {version()}\nSummary: {SUMMARY}\n"
            "License: LGPL-3.0-or-later\nRequires-Python: >=3.9\nRequires-Dist: numpy\n"
            "Description-Content-Type: text/markdown\n\n" + readme)


def tag():
    """This Python, on this platform."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def run(*command):
    """Without what pip hides from a build: CMake asks whether this Python has NumPy, as it will when it is used."""
    environment = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "PYTHONNOUSERSITE")}
    try:
        subprocess.run(command, check=True, stdout=sys.stderr, env=environment)
    except FileNotFoundError:
        raise SystemExit(f"{command[0]} is missing; packages.txt lists what AF2 needs to be built") from None


def built(folder):
    """Configures the folder, unless that has been done, and builds the extension module in it."""
    if not (folder / "CMakeCache.txt").exists():
        run("cmake", "-S", str(SOURCE), "-B", str(folder), "-G", "Ninja", "-DAF2_BUILD_TESTS=OFF", "-DAF2_BUILD_CLI=OFF",
            f"-DPython3_EXECUTABLE={sys.executable}")
    run("cmake", "--build", str(folder), "--target", "af2_python")


def packaged_files(build, stage):
    """The package as CMake installs it: path in the wheel, and content."""
    run("cmake", "--install", str(build), "--component", "python", "--prefix", str(stage))
    found = list(stage.rglob("af2/__init__.py"))
    if not found:
        raise SystemExit(f"{build} does not build the Python package; CMake needs pybind11, the headers of Python and NumPy")
    root = found[0].parents[1]
    return [(str(path.relative_to(root)), path.read_bytes()) for path in sorted(root.rglob("*")) if path.is_file()]


def writer_modules(build, stage):
    """The libraries that write formats of others, as far as they were built: beside the extension module, which loads them."""
    run("cmake", "--install", str(build), "--component", "formats", "--prefix", str(stage))
    return [(f"af2/{path.name}", path.read_bytes()) for path in sorted(stage.rglob("*.so"))]


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def info_files():
    """What stands in the dist-info folder, besides the record."""
    info = f"{NAME}-{version()}.dist-info"
    wheel = f"Wheel-Version: 1.0\nGenerator: af2\nRoot-Is-Purelib: false\nTag: {tag()}\n"
    files = [(f"{info}/METADATA", metadata().encode()), (f"{info}/WHEEL", wheel.encode())]
    for licence in ("LICENSE", "COPYING", "NOTICE"):
        files.append((f"{info}/{licence}", (SOURCE / licence).read_bytes()))
    return info, files


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    folder = (config_settings or {}).get("build-dir") or SOURCE / "build" / "wheel"
    build = pathlib.Path(folder).resolve()
    built(build)
    info, files = info_files()
    with tempfile.TemporaryDirectory() as package, tempfile.TemporaryDirectory() as modules:
        files = packaged_files(build, pathlib.Path(package)) + writer_modules(build, pathlib.Path(modules)) + files
    record = "".join(record_line(*file) for file in files) + f"{info}/RECORD,,\n"
    files.append((f"{info}/RECORD", record.encode()))
    name = f"{NAME}-{version()}-{tag()}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files:
            entry = zipfile.ZipInfo(path)  # with the earliest date, so that the same files give the same wheel
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            wheel.writestr(entry, content)
    return name


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info, files = info_files()
    for path, content in files:
        target = pathlib.Path(metadata_directory) / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)
    return info


def build_sdist(sdist_directory, config_settings=None):
    """The files that git has."""
    listed = subprocess.run(["git", "-C", str(SOURCE), "ls-files", "-z"], check=True, capture_output=True).stdout
    name = f"{NAME}-{version()}"
    with tarfile.open(os.path.join(sdist_directory, f"{name}.tar.gz"), "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for file in sorted(filter(None, listed.decode().split("\0"))):
            archive.add(SOURCE / file, f"{name}/{file}", recursive=False)
        with tempfile.NamedTemporaryFile() as info:
            info.write(metadata().encode())
            info.flush()
            archive.add(info.name, f"{name}/PKG-INFO")
    return f"{name}.tar.gz"
