// A setting of OpenCASCADE's readers for a while: these are global, and a program that uses AF2 has
// its own.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <Interface_Static.hxx>

namespace af2::geometry {

/// One that is a choice among texts. To be made after the reader, which defines its settings.
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
