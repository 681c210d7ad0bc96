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

}  // namespace af2::geometry
