// Meshes divided into parts, as arrays.
#include <af2/engine/error.h>

#include "python/bindings/common.h"
#ifdef AF2_HAVE_METIS
#include "geometry/mpi/partition/cut_parts.h"
#include "geometry/mpi/partition/part_builder.h"
#endif

namespace af2::python {

#ifdef AF2_HAVE_METIS

namespace {

using mpi::OwnedPart;

/// Signed, as Python's packages want indices.
py::array idsOf(const std::vector<std::uint64_t>& ids) {
  return arrayOf(std::vector<std::int64_t>(ids.begin(), ids.end()));
}

/// One row for each item; -1 where an item has no vertex.
template <class Item, std::size_t kColumns, class VerticesOf>
py::array indicesOf(const std::vector<Item>& items, const VerticesOf& verticesOf) {
  py::array_t<std::int32_t> array(
      {static_cast<py::ssize_t>(items.size()), static_cast<py::ssize_t>(kColumns)});
  auto rows = array.template mutable_unchecked<2>();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::array<VertexId, kColumns> vertices = verticesOf(items[i]);
    for (std::size_t k = 0; k < kColumns; ++k)
      rows(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) =
          vertices[k].isNone() ? -1 : static_cast<std::int32_t>(vertices[k].value);
  }
  return array;
}

py::dict toPython(const OwnedPart& part) {
  std::vector<std::uint64_t> lineIds;
  std::vector<std::int32_t> lineEdges;
  for (const mpi::OwnedLine& line : part.lines) {
    lineIds.push_back(line.id);
    lineEdges.push_back(line.edge);
  }
  const std::vector<std::uint64_t> begin(part.ghostsBegin.begin(), part.ghostsBegin.end());
  py::dict fields;
  fields["part"] = part.process;
  fields["parts"] = part.processes;
  fields["points"] = arrayOf(part.vertices);
  fields["owned_points"] = part.ownedVertices;
  fields["point_ids"] = idsOf(part.vertexIds);
  fields["point_numbers"] = idsOf(part.vertexNumbers);
  fields["point_owners"] = arrayOf(part.vertexOwners);
  fields["elements"] =
      indicesOf<Element, 4>(part.elements, [](const Element& e) { return e.corners; });
  fields["owned_elements"] = part.ownedElements;
  fields["element_ids"] = idsOf(part.elementIds);
  fields["element_numbers"] = idsOf(part.elementNumbers);
  fields["element_owners"] = arrayOf(part.elementOwners);
  fields["face"] = arrayOf(part.face);
  fields["midsides"] = indicesOf<std::array<VertexId, 4>, 4>(
      part.midsides, [](const std::array<VertexId, 4>& m) { return m; });
  fields["ghosts_begin"] = idsOf(begin);
  fields["ghosts_of"] = arrayOf(part.ghostsOf);
  fields["lines"] = indicesOf<mpi::OwnedLine, 3>(part.lines, [](const mpi::OwnedLine& line) {
    return std::array{line.from, line.to, line.middle};
  });
  fields["line_ids"] = idsOf(lineIds);
  fields["line_edges"] = arrayOf(lineEdges);
  return fields;
}

py::list parts(const geometry::ModelMesh& mesh, int count, bool allLines) {
  std::vector<OwnedPart> cut;
  {
    const py::gil_scoped_release noGil;
    const auto lines =
        lineElements(mesh, allLines ? geometry::LinesAlong::AllEdges : geometry::LinesAlong());
    std::vector<mpi::PartBuilder> builders;
    for (int part = 0; part < count; ++part) builders.emplace_back(part);
    std::vector<mpi::PartEnd> ends =
        cutParts(mesh, mpi::divideMesh(mesh, count), lines, [&](int part, mpi::PartPiece&& piece) {
          builders[static_cast<std::size_t>(part)].take(piece);
        });
    for (std::size_t part = 0; part < builders.size(); ++part)
      cut.push_back(builders[part].finish(std::move(ends[part])));
  }
  py::list all;
  for (OwnedPart& part : cut) {
    all.append(toPython(part));
    part = {};
  }
  return all;
}

}  // namespace

#else

namespace {

py::list parts(const geometry::ModelMesh&, int, bool) {
  throw InputError("this AF2 was built without METIS, so it cannot divide meshes into parts");
}

}  // namespace

#endif

void bindMeshParts(py::module_& module) { module.def("parts", &parts); }

}  // namespace af2::python
