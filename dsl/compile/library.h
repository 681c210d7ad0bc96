// Files and the files that they import.
#pragma once

#include <filesystem>
#include <istream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "dsl/compile/expressions.h"
#include "dsl/compile/module.h"

namespace af2::dsl {

/// Reads a file and everything that it imports, and registers what each defines.
class Library {
 public:
  Library(CompileContext& context, std::vector<std::filesystem::path> searchPaths,
          TextSource unsaved = {})
      : context_(context), searchPaths_(std::move(searchPaths)), unsaved_(std::move(unsaved)) {}

  const Module& load(std::string name, std::string text);
  std::vector<std::unique_ptr<Module>> takeModules() { return std::move(modules_); }
  const std::vector<std::unique_ptr<Module>>& modules() const { return modules_; }

 private:
  const Module* import(Module& into, const Import& item);
  std::filesystem::path findFile(const Module& from, const std::string& path) const;
  bool isThere(const std::filesystem::path& path) const;
  std::optional<std::string> read(const std::filesystem::path& path, std::string& fault) const;
  void registerItems(Module& module);
  void registerConstant(Module& module, const Constant& item);
  void registerFunction(Module& module, const Name& name, const std::vector<Name>& parameters,
                        const Expr& body, bool isMetric);
  void registerExtern(Module& module, const Extern& item);
  void registerTemplate(Module& module, const Template& item);
  void registerImport(Module& module, const Import& item);
  bool isFree(const Module& module, const Name& name, bool isFunction);

  CompileContext& context_;
  std::vector<std::filesystem::path> searchPaths_;
  TextSource unsaved_;
  std::vector<std::unique_ptr<Module>> modules_;
  std::map<std::string, Module*> byPath_;
  std::vector<const Module*> loading_;  ///< the chain of imports to the current file
};

/// Reads a text up to one byte more than the limit for rule files, so that a longer file is
/// noticed.
std::string readRuleText(std::istream& in);

/// Reads a file in the same way. Returns nothing on failure; then `fault` gives the reason.
std::optional<std::string> readFile(const std::filesystem::path& path, std::string& fault);

}  // namespace af2::dsl
