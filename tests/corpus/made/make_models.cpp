// Makes CAD models from drawn numbers: `make_models FOLDER COUNT [FIRST]` writes COUNT models of
// each family, the same ones on every run with the same OpenCASCADE, in turn as BREP, STEP and
// IGES.
#include <sys/wait.h>
#include <unistd.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "tests/corpus/made/families.h"
#include "tests/corpus/made/shapes.h"

namespace af2::made {
namespace {

/// Seconds after which OpenCASCADE is not expected to come to an end.
constexpr unsigned kMaxSeconds = 20;

double areaOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.Mass();
}

/// Boolean operations can leave vertices that are said to be as large as a face.
bool isFit(const TopoDS_Shape& shape) {
  return !shape.IsNull() && !facesOf(shape).empty() && BRepCheck_Analyzer(shape).IsValid() &&
         BRep_Tool::MaxTolerance(shape, TopAbs_VERTEX) < 0.1;
}

/// What goes through IGES may lose shared faces, holes across seams, or the place of a curve.
bool isSame(const TopoDS_Shape& shape, const TopoDS_Shape& read) {
  return !read.IsNull() && facesOf(read).size() == facesOf(shape).size() &&
         std::abs(areaOf(read) / areaOf(shape) - 1) < 1e-4 &&
         BRep_Tool::MaxTolerance(read, TopAbs_EDGE) < 1e-2;
}

template <typename Reader>
TopoDS_Shape readBack(const std::string& path) {
  Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return {};
  reader.TransferRoots();
  return reader.OneShape();
}

bool write(const TopoDS_Shape& shape, const std::string& path, int number) {
  if (number % 3 == 1) {
    const std::string step = path + ".step";
    STEPControl_Writer writer;
    writer.Transfer(shape, STEPControl_AsIs);
    if (writer.Write(step.c_str()) == IFSelect_RetDone &&
        isSame(shape, readBack<STEPControl_Reader>(step)))
      return true;
    std::remove(step.c_str());
  }
  if (number % 3 == 2) {
    const std::string iges = path + ".igs";
    IGESControl_Writer writer("MM", number % 2);
    if (writer.AddShape(shape) && writer.Write(iges.c_str()) &&
        isSame(shape, readBack<IGESControl_Reader>(iges)))
      return true;
    std::remove(iges.c_str());
  }
  return BRepTools::Write(shape, (path + ".brep").c_str());
}

/// By the name, so that other families do not matter.
std::uint64_t seedOf(const std::string& name, int number) {
  std::uint64_t seed = static_cast<std::uint64_t>(number);
  for (const char letter : name) seed = 31 * seed + static_cast<unsigned char>(letter);
  return seed;
}

bool makeOne(const Family& family, int number, const std::string& path) {
  try {
    Draw draw(seedOf(family.name, number));
    const TopoDS_Shape shape = family.make(draw);
    return isFit(shape) && write(shape, path, number);
  } catch (const Standard_Failure&) {
    return false;
  } catch (const std::exception&) {
    return false;
  }
}

/// In a process of its own, as OpenCASCADE can crash or hang over what it is asked for.
bool makeOneApart(const Family& family, int number, const std::string& path) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(kMaxSeconds);
    _exit(makeOne(family, number, path) ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status == 0;
}

/// How many of them came to be.
int makeSome(const Family& family, int first, int count, const std::string& folder) {
  int made = 0;
  for (int number = first; number < first + count; ++number) {
    char name[80];
    std::snprintf(name, sizeof name, "/%s_%03d", family.name, number);
    made += makeOneApart(family, number, folder + name) ? 1 : 0;
  }
  return made;
}

std::vector<Family> allFamilies() {
  std::vector<Family> families = partFamilies();
  for (const auto& more :
       {sweptFamilies(), surfaceFamilies(), creasedFamilies(), profiledFamilies(),
        productFamilies(), ornateFamilies(), awkwardFamilies()})
    families.insert(families.end(), more.begin(), more.end());
  return families;
}

}  // namespace
}  // namespace af2::made

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: make_models FOLDER COUNT [FIRST]\n");
    return 2;
  }
  std::error_code error;
  std::filesystem::create_directories(argv[1], error);
  if (error) {
    std::fprintf(stderr, "make_models: %s cannot be made: %s\n", argv[1], error.message().c_str());
    return 1;
  }
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const int count = std::atoi(argv[2]), first = argc > 3 ? std::atoi(argv[3]) : 0;
  for (const af2::made::Family& family : af2::made::allFamilies()) {
    std::printf("%-20s %d\n", family.name, af2::made::makeSome(family, first, count, argv[1]));
    std::fflush(stdout);
  }
  return 0;
}
