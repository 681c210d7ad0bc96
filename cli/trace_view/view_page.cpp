#include "cli/trace_view/view_page.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/page/page_writer.h"

namespace af2::cli {
namespace {

using Json = nlohmann::ordered_json;

Json ruleJson(const AF2Rule& rule, const geometry::RuleText& text) {
  const RuleDefinition& definition = rule.definition();
  Json vertices = Json::array(), edges = Json::array(), elements = Json::array();
  for (const PatternVertex& vertex : definition.vertices) vertices.push_back(vertex.name);
  for (const PatternEdge& edge : definition.edges) edges.push_back({edge.from, edge.to});
  for (const RuleElement& element : definition.elements)
    elements.push_back(
        std::vector<int>(element.corners.begin(), element.corners.begin() + element.size()));
  return {{"name", rule.name()}, {"file", text.file},    {"line", text.line},
          {"text", text.text},   {"vertices", vertices}, {"new", definition.newVertexNames},
          {"edges", edges},      {"elements", elements}, {"closes", rule.newEdges().empty()}};
}

/// The records one after the other: numbers of vertices, events and so on count over all faces.
class ViewWriter {
 public:
  ViewWriter(const ViewSubject& subject, const std::vector<FaceRecord*>& faces)
      : subject_(subject), faces_(faces) {
    for (const FaceRecord* face : faces_) {
      bases_.push_back(next_);
      next_.vertices += face->vertices.size();
      next_.events += face->events.size();
      next_.fronts += face->fronts.size();
      next_.charts += face->charts.size();
    }
    findCentre();
  }

  void write(geometry::OutputFile& file) const {
    const std::string info = infoJson().dump(-1, ' ', false, Json::error_handler_t::replace);
    geometry::writePageJson("info", geometry::jsonInScript(info), file);
    writePoints("positions", &FaceRecord::vertices, file);
    writePoints("moves", &FaceRecord::moves, file);
    geometry::writePageArray("moved", "Uint32", file, [&](geometry::Base64Stream& out) {
      for (std::size_t f = 0; f < faces_.size(); ++f)
        for (const std::uint32_t vertex : faces_[f]->moved)
          out.put(static_cast<std::uint32_t>(vertex + bases_[f].vertices));
    });
    writeEvents(file);
    writeElements(file);
    file.text("<script type=\"text/plain\" id=\"charts\">");
    for (const FaceRecord* face : faces_)
      for (const std::string& chart : face->charts) {
        file.text(chart);
        file.text("\n");
      }
    file.text("</script>\n");
  }

 private:
  struct Base {
    std::size_t vertices = 0, events = 0, fronts = 0, charts = 0;
  };

  void findCentre() {
    Point3 low{INFINITY, INFINITY, INFINITY}, high = -1.0 * low;
    for (const FaceRecord* face : faces_)
      for (const Point3& p : face->vertices) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    if (low.x <= high.x) centre_ = 0.5 * (low + high);
  }

  Json infoJson() const {
    const auto& rules = subject_.rules.rules();
    Json json{{"title", subject_.mesh.name.empty() ? "Run" : subject_.mesh.name},
              {"unit", subject_.mesh.unit},
              {"centre", {centre_.x, centre_.y, centre_.z}},
              {"maxLevel", subject_.rules.maxLevel()},
              {"firstStep", subject_.firstStep},
              {"lastStep", subject_.lastStep},
              {"notes", subject_.notes},
              {"rules", Json::array()},
              {"reasons", Json::array()},
              {"acts", Json::array()},
              {"faces", Json::array()},
              {"fronts", Json::array()}};
    for (std::size_t rule = 0; rule < rules.size(); ++rule)
      json["rules"].push_back(ruleJson(rules[rule], rule < subject_.ruleTexts.size()
                                                        ? subject_.ruleTexts[rule]
                                                        : geometry::RuleText{}));
    for (int reason = 0; reason <= static_cast<int>(Refusal::Beaten); ++reason)
      json["reasons"].push_back(toString(static_cast<Refusal>(reason)));
    for (int kind = 0; kind < kFinishActKinds; ++kind)
      json["acts"].push_back(toString(static_cast<FinishAct::Kind>(kind)));
    for (std::size_t f = 0; f < faces_.size(); ++f) addFace(f, json);
    return json;
  }

  void addFace(std::size_t f, Json& json) const {
    const FaceRecord& face = *faces_[f];
    json["faces"].push_back({{"id", face.face}, {"firstEvent", bases_[f].events}});
    for (std::size_t number = 0; number < face.fronts.size(); ++number) {
      const ViewFront& front = face.fronts[number];
      Json entry{{"face", face.face},
                 {"number", number + 1},
                 {"firstEvent", bases_[f].events + static_cast<std::size_t>(front.firstEvent)},
                 {"firstVertex", bases_[f].vertices + front.firstVertex},
                 {"vertexCount", front.vertexCount},
                 {"given", front.given},
                 {"edgesLeft", front.edgesLeft}};
      if (front.kept != ViewFront::Kept::Unknown)
        entry["kept"] = front.kept == ViewFront::Kept::Yes;
      json["fronts"].push_back(std::move(entry));
    }
  }

  void writePoints(const char* name, std::vector<Point3> FaceRecord::*points,
                   geometry::OutputFile& file) const {
    geometry::writePageArray(name, "Float32", file, [&](geometry::Base64Stream& out) {
      for (const FaceRecord* face : faces_)
        for (const Point3& point : face->*points) {
          const Point3 p = point - centre_;
          for (const double x : {p.x, p.y, p.z}) out.put(static_cast<float>(x));
        }
    });
  }

  /// `put` writes one value of an event, given the event and the numbers at which its face begins.
  template <class Put>
  void writeOfEvents(const char* name, const char* type, geometry::OutputFile& file,
                     Put put) const {
    geometry::writePageArray(name, type, file, [&](geometry::Base64Stream& out) {
      for (std::size_t f = 0; f < faces_.size(); ++f)
        for (const ViewEvent& event : faces_[f]->events) put(out, event, bases_[f]);
    });
  }

  void writeEvents(geometry::OutputFile& file) const {
    const auto shifted = [](std::uint32_t vertex, const Base& base) {
      return vertex == ViewElement::kNoVertex ? vertex
                                              : static_cast<std::uint32_t>(vertex + base.vertices);
    };
    using Out = geometry::Base64Stream;
    using Event = ViewEvent;
    writeOfEvents("kind", "Uint8", file,
                  [](Out& o, const Event& e, const Base&) { o.put(e.kind); });
    writeOfEvents("level", "Uint8", file,
                  [](Out& o, const Event& e, const Base&) { o.put(e.level); });
    writeOfEvents("rule", "Int32", file,
                  [](Out& o, const Event& e, const Base&) { o.put(e.rule); });
    writeOfEvents("front", "Int32", file, [](Out& o, const Event& e, const Base& b) {
      o.put(static_cast<std::int32_t>(static_cast<std::size_t>(e.front) + b.fronts));
    });
    writeOfEvents("chart", "Int32", file, [](Out& o, const Event& e, const Base& b) {
      o.put(e.chart < 0 ? e.chart : e.chart + static_cast<std::int32_t>(b.charts));
    });
    writeOfEvents("from", "Uint32", file,
                  [&](Out& o, const Event& e, const Base& b) { o.put(shifted(e.from, b)); });
    writeOfEvents("to", "Uint32", file,
                  [&](Out& o, const Event& e, const Base& b) { o.put(shifted(e.to, b)); });
    writeOfEvents("moveCount", "Uint32", file,
                  [](Out& o, const Event& e, const Base&) { o.put(e.moves); });
    writeOfEvents("before", "Float32", file,
                  [](Out& o, const Event& e, const Base&) { o.put(e.before); });
    writeOfEvents("after", "Float32", file,
                  [](Out& o, const Event& e, const Base&) { o.put(e.after); });
  }

  template <class Put>
  void writeOfElements(const char* name, const char* type, geometry::OutputFile& file,
                       Put put) const {
    geometry::writePageArray(name, type, file, [&](geometry::Base64Stream& out) {
      for (std::size_t f = 0; f < faces_.size(); ++f)
        for (const ViewElement& element : faces_[f]->elements) put(out, element, bases_[f]);
    });
  }

  void writeElements(geometry::OutputFile& file) const {
    using Out = geometry::Base64Stream;
    using Element = ViewElement;
    const auto event = [](std::int32_t number, const Base& base) {
      return number == kNever ? number : number + static_cast<std::int32_t>(base.events);
    };
    writeOfElements("corners", "Uint32", file, [](Out& o, const Element& e, const Base& b) {
      for (const std::uint32_t v : e.corners)
        o.put(v == Element::kNoVertex ? v : static_cast<std::uint32_t>(v + b.vertices));
    });
    writeOfElements("birth", "Int32", file,
                    [&](Out& o, const Element& e, const Base& b) { o.put(event(e.birth, b)); });
    writeOfElements("death", "Int32", file,
                    [&](Out& o, const Element& e, const Base& b) { o.put(event(e.death, b)); });
  }

  const ViewSubject& subject_;
  const std::vector<FaceRecord*>& faces_;
  std::vector<Base> bases_;  ///< by face
  Base next_;
  Point3 centre_;
};

}  // namespace

void writeViewPage(const ViewSubject& subject, const std::vector<FaceRecord*>& faces,
                   const std::filesystem::path& file) {
  const ViewWriter writer(subject, faces);
  geometry::OutputFile output(file);
  geometry::fillPage("trace/page.html", output, [&] { writer.write(output); });
  output.commit();
}

}  // namespace af2::cli
