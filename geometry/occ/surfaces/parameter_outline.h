// Which parameters of a surface are on a face, for many of them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <BRepTopAdaptor_FClass2d.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <map>
#include <optional>
#include <vector>

namespace af2::geometry {

/// The boundary of a face as chords in the parameters of its surface. Where it is for some u is
/// found once, so many places should have the same u.
class ParameterOutline {
 public:
  /// face  oriented forward
  explicit ParameterOutline(const TopoDS_Face& face);

  /// Between the boundary and its chords, the answer may be that for the other side. Where the
  /// boundary is not closed in the parameters, OpenCASCADE decides.
  bool has(double u, double v);

 private:
  struct Chord {
    double u1, v1, u2, v2;  // u1 < u2
  };
  void add(const TopoDS_Edge& edge);
  const std::vector<double>& crossingsAt(double u);

  TopoDS_Face face_;
  std::vector<Chord> chords_;
  double area_ = 0;  // in the parameters; negative: what it has is beyond its boundary
  /// By u: at which v the boundary is, in ascending order.
  std::map<double, std::vector<double>> crossings_;
  std::optional<BRepTopAdaptor_FClass2d> otherwise_;
};

}  // namespace af2::geometry
