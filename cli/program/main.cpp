// The program af2. This file only lists its verbs; each has its own file.
#include <cstdio>
#include <cstdlib>

#include "cli/program/freed_memory.h"
#include "cli/program/program.h"
#include "cli/program/verbs.h"

int main(int count, char** arguments) {
  using namespace af2::cli;
  static constexpr Verb kVerbs[] = {
      {"mesh", "mesh the faces of a model", declareMesh},
      {"inspect", "list faces, edges, groups and defects of a model", declareInspect},
      {"quality", "measure the quality of a mesh file", declareQuality},
      {"explain", "explain why a rule was or was not applied in a run", declareExplain},
      {"stats", "count what the rules did in a run", declareStats},
      {"trace", "compare the traces of two runs", declareTrace},
      {"compare", "compare the meshes of two rule sets", declareCompare},
      {"check", "find mistakes in rule files", declareCheck},
      {"test", "run the tests of rule files", declareTest},
      {"fmt", "format rule files", declareFmt},
      {"draw", "draw rules", declareDraw},
      {"doc", "make an HTML page about a rule set", declareDoc},
      {"new", "create a rule set or a rule", declareNew},
      {"eval", "evaluate one rule at given positions", declareEval},
      {"compile", "show the compiled form of rules", declareCompile},
      {"import", "convert rule files of Netgen (.rls)", declareImport},
      {"explain-code", "explain the code of a diagnostic", declareExplainCode},
      {"playground", "edit rules in a browser beside what they do", declarePlayground},
      {"lsp", "run the language server for editors", declareLsp},
      {"completion", "print a script that completes commands in a shell", declareCompletion, true},
      {"manual", "print the manual page of a verb", declareManual, true},
      {"version", "print the version", declareVersion},
  };
  keepFreedMemory();
  const int code = runProgram(kVerbs, count, arguments);
  std::fflush(nullptr);
  std::_Exit(code);  // all files are closed; to take libraries down one by one only takes time
}
