// The program af2. Here is only the list of its verbs; each has a file of its own.
#include "cli/program/program.h"
#include "cli/program/verbs.h"

int main(int count, char** arguments) {
  using namespace af2::cli;
  static constexpr Verb kVerbs[] = {
      {"mesh", "mesh the faces of a model", declareMesh},
      {"inspect", "list faces, edges, groups and defects of a model", declareInspect},
      {"check", "find mistakes in rule files", declareCheck},
      {"test", "run the tests of rule files", declareTest},
      {"fmt", "lay out rule files", declareFmt},
      {"draw", "draw rules", declareDraw},
      {"doc", "make a gallery of a rule set", declareDoc},
      {"new", "begin a rule set or a rule", declareNew},
      {"eval", "tell what one rule does at given positions", declareEval},
      {"compile", "show what rules become", declareCompile},
      {"import", "rewrite rule files of Netgen (.rls)", declareImport},
      {"explain-code", "explain the code of a diagnostic", declareExplainCode},
      {"lsp", "serve editors: the language server", declareLsp},
      {"version", "tell the version", declareVersion},
  };
  return runProgram(kVerbs, count, arguments);
}
