// A STEP file with those that it refers to: reads their shapes and finds out what parts there are.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <STEPControl_Reader.hxx>
#include <TopLoc_Location.hxx>
#include <XSControl_WorkSession.hxx>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geometry/occ/step/step_parts.h"

namespace af2::geometry {

/// A part in a place.
struct PlacedStepPart {
  std::size_t part = 0;
  TopLoc_Location place;
};

/// Where a file is that another one refers to.
std::filesystem::path besideStepFile(const std::filesystem::path& file, const std::string& name);

/// Gives a reader the text of a file, mended (mendStepText).
IFSelect_ReturnStatus readStepText(STEPControl_Reader& reader, const std::filesystem::path& path,
                                   std::string text);

class StepDocument {
 public:
  /// Makes shapes of all that a file has, and of the files that it refers to; returns whether there
  /// are any.
  ///
  /// reader  has read the file
  bool transfer(STEPControl_Reader& reader, const std::filesystem::path& path);

  const StepParts& parts() const { return parts_; }
  /// Those that no assembly uses.
  std::vector<PlacedStepPart> tops() const;
  /// The session of another file that was read; null if it was not.
  Handle(XSControl_WorkSession) sessionOf(const std::filesystem::path& path) const;
  /// All parts in their places, also those from other files. Assemblies get these, too.
  TopoDS_Shape joined();

 private:
  struct OtherFile {
    Handle(XSControl_WorkSession) session;  ///< null: it could not be read
    int top = -1;                           ///< index in tops_ of its first shape
  };
  struct Top : PlacedStepPart {
    bool isUsed = false;
  };
  class PartFinder;

  void readOthers(const Handle(XSControl_WorkSession) & session, const std::filesystem::path& path,
                  PartFinder& finder);
  const OtherFile& readOther(const std::filesystem::path& path);

  StepParts parts_;
  std::vector<Top> tops_;
  std::map<std::filesystem::path, OtherFile> others_;
  std::vector<std::filesystem::path> open_;  ///< files that refer to the one that is read
};

}  // namespace af2::geometry
