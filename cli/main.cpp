// The program af2. Here is only the list of its verbs; each has a file of its own.
#include "cli/program.h"
#include "cli/verbs.h"

int main(int count, char** arguments) {
  using namespace af2::cli;
  static constexpr Verb kVerbs[] = {
      {"mesh", "mesh the faces of a model", declareMesh},
      {"inspect", "list the faces and edges of a model", declareInspect},
      {"version", "tell the version", declareVersion},
  };
  return runProgram(kVerbs, count, arguments);
}
