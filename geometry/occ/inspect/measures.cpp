#include "geometry/occ/inspect/measures.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "geometry/occ/base/points.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

namespace {

/// Points of a face along each of its parameters.
constexpr int kSamples = 11;

template <class Measures>
void measureBox(const TopoDS_Shape& shape, Measures& measures) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, false, false);
  if (box.IsVoid() || box.IsOpen()) throw Standard_Failure("no box");
  box.SetGap(0);
  measures.low = toPoint(box.CornerMin());
  measures.high = toPoint(box.CornerMax());
}

/// At points of a grid in the parameters that are inside of the face.
void measureBend(const TopoDS_Face& face, FaceMeasures& measures) {
  double u1, u2, v1, v2;
  BRepTools::UVBounds(face, u1, u2, v1, v2);
  const BRepAdaptor_Surface surface(face);
  const BRepTopAdaptor_FClass2d inside(face, 1e-9);
  BRepLProp_SLProps bend(surface, 2, 1e-9);
  measures.place = measures.centroid;
  double nearest = std::numeric_limits<double>::infinity(), least = nearest;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const gp_Pnt2d at(u1 + (u2 - u1) * (i + 0.5) / kSamples,
                        v1 + (v2 - v1) * (j + 0.5) / kSamples);
      if (inside.Perform(at) != TopAbs_IN) continue;
      bend.SetParameters(at.X(), at.Y());
      const Point3 place = toPoint(bend.Value());
      if (const double d = distance(place, measures.centroid); d < nearest) {
        nearest = d;
        measures.place = place;
      }
      if (!bend.IsCurvatureDefined()) continue;
      const double larger = std::max(std::abs(bend.MaxCurvature()), std::abs(bend.MinCurvature()));
      least = std::min(least, larger);
      measures.greatestCurvature = std::max(measures.greatestCurvature, larger);
    }
  if (std::isfinite(least)) measures.leastCurvature = least;
}

void findNeighbors(const ModelShape& shape, FaceMeasures& measures) {
  std::set<int> edges, neighbors;
  for (const auto& use : shape.edgesOfFaces.at(static_cast<std::size_t>(measures.id) - 1)) {
    edges.insert(use.id);
    for (const int face : shape.facesOfEdges.at(static_cast<std::size_t>(use.id) - 1))
      neighbors.insert(face);
  }
  neighbors.erase(measures.id);
  measures.edges.assign(edges.begin(), edges.end());
  measures.neighbors.assign(neighbors.begin(), neighbors.end());
}

}  // namespace

std::vector<std::optional<FaceMeasures>> measuresOfFaces(const Model& model) {
  const ModelShape& shape = model.shape();
  std::vector<std::optional<FaceMeasures>> all;
  for (int id = 1; id <= shape.faces.Extent(); ++id) {
    FaceMeasures measures;
    measures.id = id;
    findNeighbors(shape, measures);
    try {
      const TopoDS_Face face = shape.face(id);
      GProp_GProps area;
      BRepGProp::SurfaceProperties(face, area);
      measures.area = std::abs(area.Mass());
      measures.centroid = toPoint(area.CentreOfMass());
      measureBox(face, measures);
      measureBend(face, measures);
      all.emplace_back(std::move(measures));
    } catch (const Standard_Failure&) {  // `defects` reports it
      all.emplace_back();
    }
  }
  return all;
}

std::vector<SolidMeasures> measuresOfSolids(const Model& model) {
  const ModelShape& shape = model.shape();
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(shape.shape, TopAbs_SOLID, solids);
  std::vector<SolidMeasures> all;
  for (int i = 1; i <= solids.Extent(); ++i) {
    SolidMeasures measures;
    measures.number = i;
    std::set<int> faces;
    for (TopExp_Explorer it(solids(i), TopAbs_FACE); it.More(); it.Next())
      if (const int id = shape.faces.FindIndex(it.Current()); id > 0) faces.insert(id);
    measures.faces.assign(faces.begin(), faces.end());
    try {
      GProp_GProps volume;
      BRepGProp::VolumeProperties(solids(i), volume);
      measures.volume = volume.Mass();
      measures.centroid = toPoint(volume.CentreOfMass());
      measureBox(solids(i), measures);
      all.push_back(std::move(measures));
    } catch (const Standard_Failure&) {  // its faces are measured
    }
  }
  return all;
}

}  // namespace af2::geometry
