// Changes a setting of OpenCASCADE's readers temporarily, because the settings are global and a
// program that uses AF2 may have its own.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <Interface_Static.hxx>

namespace af2::geometry {

/// A setting with a text as its value. Construct it after the reader, because the reader defines
/// its settings.
class ReaderSetting {
 public:
  ReaderSetting(const char* name, const char* choice)
      : name_(name), before_(Interface_Static::IVal(name)) {
    Interface_Static::SetCVal(name, choice);
  }
  ReaderSetting(const ReaderSetting&) = delete;
  ReaderSetting& operator=(const ReaderSetting&) = delete;
  ~ReaderSetting() { Interface_Static::SetIVal(name_, before_); }

 private:
  const char* name_;
  int before_;
};

/// Readers would compare the normals of both faces at every edge to say which edges are smooth, up
/// to a tenth of the time of reading (docs/performance.md). Nothing here asks for that.
class WithoutSmoothEdges {
 public:
  WithoutSmoothEdges() : before_(Interface_Static::RVal(kAngle)) {
    Interface_Static::SetRVal(kAngle, 0);
  }
  WithoutSmoothEdges(const WithoutSmoothEdges&) = delete;
  WithoutSmoothEdges& operator=(const WithoutSmoothEdges&) = delete;
  ~WithoutSmoothEdges() { Interface_Static::SetRVal(kAngle, before_); }

 private:
  static constexpr const char* kAngle = "read.encoderegularity.angle";
  double before_;
};

}  // namespace af2::geometry
