#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <iterator>

#include "engine/base/error.h"
#include "geometry/base/utf8.h"
#include "geometry/base/words.h"
#include "geometry/occ/base/quick_repairs.h"
#include "geometry/occ/base/trial.h"
#include "geometry/occ/model/turned_faces.h"
#include "geometry/occ/read/reader_setting.h"
#include "geometry/occ/read/readers.h"
#include "geometry/occ/step/damaged_entities.h"
#include "geometry/occ/step/external_parts.h"
#include "geometry/occ/step/lost_step_faces.h"
#include "geometry/occ/step/step_document.h"
#include "geometry/occ/step/step_groups.h"
#include "geometry/occ/step/step_numbers.h"
#include "geometry/occ/step/without_checks.h"

namespace af2::geometry {

namespace {

/// The faces as the file gives them, found by the shape that each became.
class StepFaces {
 public:
  void add(const Handle(Transfer_TransientProcess) & process) {
    for (int i = 1; i <= process->NbMapped(); ++i) {
      const auto face = Handle(StepShape_FaceSurface)::DownCast(process->Mapped(i));
      if (face.IsNull()) continue;
      const TopoDS_Shape shape = TransferBRep::ShapeResult(process, face);
      if (shape.IsNull()) continue;
      index_.Bind(shape.Located(TopLoc_Location()), static_cast<int>(faces_.size()));
      faces_.push_back(face);
    }
  }

  std::string nameOf(const TopoDS_Face& face) const {
    const Handle(StepShape_FaceSurface) found = find(face);
    if (found.IsNull() || found->Name().IsNull()) return "";
    const std::string name = found->Name()->ToCString();
    return isName(name) ? name : "";
  }

  /// Whether the face looks to the side of its surface that the file says.
  bool isAsInFile(const TopoDS_Face& face) const {
    const Handle(StepShape_FaceSurface) found = find(face);
    return found.IsNull() || found->SameSense() == (face.Orientation() == TopAbs_FORWARD);
  }

 private:
  Handle(StepShape_FaceSurface) find(const TopoDS_Face& face) const {
    const int* index = index_.Seek(face.Located(TopLoc_Location()));
    return index ? faces_[static_cast<std::size_t>(*index)] : Handle(StepShape_FaceSurface)();
  }

  /// Some systems write a placeholder or the number of the entity.
  static bool isName(const std::string& name) {
    return !name.empty() && name != "NONE" && name[0] != '#';
  }

  TopTools_DataMapOfShapeInteger index_;
  std::vector<Handle(StepShape_FaceSurface)> faces_;
};

/// Files may mix units: all that there are.
std::string lengthUnitsOf(STEPControl_Reader& reader) {
  TColStd_SequenceOfAsciiString lengths, angles, solidAngles;
  reader.FileUnits(lengths, angles, solidAngles);
  std::vector<std::string> units;
  for (const TCollection_AsciiString& length : lengths)
    if (!std::ranges::count(units, length.ToCString())) units.emplace_back(length.ToCString());
  std::string text;
  for (const std::string& unit : units) text += (text.empty() ? "" : ", ") + unit;
  return text;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMaxNamed = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMaxNamed); ++i)
    text += (i > 0 ? ", '" : "'") + names[i] + "'";
  if (names.size() > kMaxNamed)
    text += " and " + std::to_string(names.size() - kMaxNamed) + " more";
  return text;
}

/// Says which other files were read, or that some cannot be.
void tell(const ExternalParts& parts, const std::filesystem::path& path,
          std::vector<std::string>& notes) {
  if (!parts.missing.empty())
    throw InputError(
        path.string() + ": parts of this assembly are in other files, of which " +
        listed(parts.missing) +
        " cannot be read; put these into the same folder, or export the assembly to one file");
  if (!parts.read.empty())
    notes.push_back("parts of the assembly were read from " + listed(parts.read));
}

}  // namespace

ReadShape readStep(const std::filesystem::path& path) {
  STEPControl_Reader reader;
  const WithoutChecks unchecked;
  const ReaderSetting unit("xstep.cascade.unit", "MM");
  const WithoutSmoothEdges smooth;
  std::string text = contentOf(path);
  const bool hasUtf8 = isUtf8(text);
  const ReaderSetting codepage("read.step.codepage", hasUtf8 ? "UTF8" : "CP1252");
  repairShapesQuickly();
  std::map<int, std::string> unusable = unusableNumbersIn(text);
  if (readStepText(reader, path, std::move(text)) != IFSelect_RetDone)
    throw InputError(path.string() +
                     ": this STEP file is damaged or truncated; export the model again");
  ReadShape result;
  if (!hasUtf8)
    result.notes.push_back("the names in the file are not in UTF-8; read as in Windows-1252");
  const StepDamage damage = takeOutDamage(reader.WS(), std::move(unusable));
  if (!damage.text.empty()) {
    constexpr std::chrono::seconds kLimit(30);
    if (!survives([&] { StepDocument().transfer(reader, path); }, kLimit))
      throw InputError(path.string() + ": " + damage.text + "; export the model again");
    result.notes.push_back(damage.text + "; parts that use them may be missing");
  }
  StepDocument document;
  document.transfer(reader, path);
  result.unit = "mm";
  result.fileUnit = lengthUnitsOf(reader);
  const ExternalParts others = externalPartsOf(reader.WS(), path, document);
  tell(others, path, result.notes);
  result.shape = others.read.empty() ? reader.OneShape() : document.joined();
  result.groups = groupsOf(document);
  StepFaces faces;
  const auto take = [&](const Handle(XSControl_WorkSession) & session,
                        const std::vector<TakenFace>& taken) {
    faces.add(session->TransferReader()->TransientProcess());
    std::ranges::move(lostStepFaces(session, taken), std::back_inserter(result.lostFaces));
  };
  take(reader.WS(), damage.faces);
  for (const auto& session : others.sessions) take(session, {});
  result.nameOf = [faces](const TopoDS_Face& face) { return faces.nameOf(face); };
  turnBackFaces(result, [&](const TopoDS_Face& face) { return faces.isAsInFile(face); });
  return result;
}

}  // namespace af2::geometry
