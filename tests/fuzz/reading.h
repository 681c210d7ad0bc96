// What must hold for any bytes that are handed to a reader: told or read, never a crash.
#pragma once

#include <string>

namespace af2::fuzz {

/// Reads, formats and, if it is sound, runs a rule file (.af2). Throws std::logic_error if the
/// readers contradict themselves.
void tryRuleFile(const std::string& text);

/// Imports a rule file of Netgen (.rls); what comes out must be a sound rule file.
void tryRlsFile(const std::string& text);

/// Reads a planar domain (.poly, .in2d) and finds its regions.
void tryPolyFile(const std::string& text);
void tryIn2dFile(const std::string& text);

/// Reads triangles (.stl, .obj), repairs them and finds their faces.
void tryStlFile(const std::string& text);
void tryObjFile(const std::string& text);

/// Reads a mesh (.vtu, .vtk, .msh, .ply, .off) and measures it.
void tryVtuFile(const std::string& text);
void tryVtkFile(const std::string& text);
void tryMshFile(const std::string& text);
void tryPlyFile(const std::string& text);
void tryOffFile(const std::string& text);

/// Reads a file of sizes (.json, .pos), and asks for sizes here and there; or of the vertices along
/// edges (.json).
void trySizeFile(const std::string& text);
void tryPosFile(const std::string& text);
void tryEdgePointFile(const std::string& text);

}  // namespace af2::fuzz
