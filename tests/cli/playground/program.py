"""Starts `af2 playground` and talks to it."""

import http.client
import json
import subprocess
import urllib.parse


class Playground:
    """The program on a file. `address` is what it has printed."""

    def __init__(self, program, *arguments):
        self.process = subprocess.Popen([program, "playground", *map(str, arguments)], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        self.address = self.process.stdout.readline().strip()
        assert self.address.startswith("http://127.0.0.1:"), self.process.stderr.read()
        self.port = urllib.parse.urlsplit(self.address).port
        self.base = urllib.parse.urlsplit(self.address).path
        self.run = 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.communicate()

    def end(self, signal):
        """Its exit code."""
        self.process.send_signal(signal)
        return self.process.wait(20)

    def ask(self, method, path, body=None, **headers):
        """Status and text of the answer to any request."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        connection.putrequest(method, path, skip_host=True, skip_accept_encoding=True)
        headers = {"Host": f"127.0.0.1:{self.port}", **{k.replace("_", "-"): v for k, v in headers.items()}}
        if body is not None:
            headers.setdefault("Content-Length", str(len(body)))
        for name, value in headers.items():
            if value is not None:
                connection.putheader(name, value)
        connection.endheaders()
        try:
            if body is not None:
                connection.send(body)
        except (BrokenPipeError, ConnectionResetError):
            pass  # refused before all was sent
        answer = connection.getresponse()
        return answer.status, answer.read().decode()

    def get(self, path):
        status, text = self.ask("GET", self.base + path)
        assert status == 200, (path, status, text)
        return json.loads(text) if path in ("file", "state") else text

    def post(self, kind, text, origin="", **parameters):
        """Status and answer to a request of the page about a text."""
        self.run += 1
        query = urllib.parse.urlencode({"page": "1", "run": self.run, **parameters})
        status, answer = self.ask("POST", f"{self.base}{kind}?{query}", text.encode(),
                                  Origin=origin or f"http://127.0.0.1:{self.port}", Content_Type="text/plain")
        return status, json.loads(answer) if status == 200 else answer

    def answer(self, kind, text, **parameters):
        status, answer = self.post(kind, text, **parameters)
        assert status == 200, (kind, status, answer)
        return answer
