// Pictures of rules as SVG, written without Cairo: dsl/picture/canvas.h for WebAssembly.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dsl/picture/canvas_view.h"
#include "engine/base/error.h"

namespace af2::dsl::picture {
namespace {

std::string paint(const char* what, Color c) {
  const auto byte = [](double share) { return static_cast<int>(std::lround(255 * share)); };
  return fmt::format("{}=\"#{:02x}{:02x}{:02x}\" {}-opacity=\"{:.3g}\"", what, byte(c.red),
                     byte(c.green), byte(c.blue), what, c.alpha);
}

std::string strokeOf(Color color, double width) {
  return fmt::format("fill=\"none\" {} stroke-width=\"{:.4g}\"", paint("stroke", color), width);
}

std::string escaped(const std::string& text) {
  std::string made;
  for (const char c : text) {
    if (c == '<')
      made += "&lt;";
    else if (c == '&')
      made += "&amp;";
    else
      made += c;
  }
  return made;
}

}  // namespace

struct Canvas::Surface {
  std::string svg;
  CanvasView view;
  int count = 0;  // of clips and gradients, which have names

  template <class... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(svg), form, std::forward<Values>(values)...);
  }
};

std::string Canvas::render(PictureFormat format, double width, double height,
                           const std::function<void(Canvas&)>& draw) {
  if (format != PictureFormat::Svg) throw InputError("only SVG pictures can be drawn here");
  Surface surface;
  surface.add(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.6g}\" height=\"{1:.6g}\" viewBox=\"0 "
      "0 {0:.6g} "
      "{1:.6g}\" stroke-linejoin=\"round\" stroke-linecap=\"round\" font-family=\"DejaVu Sans, "
      "sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height);
  Canvas canvas(surface);
  draw(canvas);
  return surface.svg + "</svg>\n";
}

Point2 Canvas::pixel(Point2 p) const { return surface_.view.pixel(p); }

void Canvas::fillRectangle(Point2 low, Point2 high, double radius, Color fill) {
  surface_.add(
      "<rect x=\"{:.6g}\" y=\"{:.6g}\" width=\"{:.6g}\" height=\"{:.6g}\" rx=\"{:.4g}\" {}/>\n",
      low.x, low.y, high.x - low.x, high.y - low.y, radius, paint("fill", fill));
}

void Canvas::strokeRectangle(Point2 low, Point2 high, double radius, Color stroke, double width) {
  surface_.add(
      "<rect x=\"{:.6g}\" y=\"{:.6g}\" width=\"{:.6g}\" height=\"{:.6g}\" rx=\"{:.4g}\" {}/>\n",
      low.x, low.y, high.x - low.x, high.y - low.y, radius, strokeOf(stroke, width));
}

void Canvas::text(const std::string& text, Point2 at, const TextStyle& style) {
  const char* const anchor = style.anchor == Anchor::Left     ? "start"
                             : style.anchor == Anchor::Middle ? "middle"
                                                              : "end";
  surface_.add(
      "<text x=\"{:.6g}\" y=\"{:.6g}\" font-size=\"{:.4g}\" text-anchor=\"{}\"{}{} {}>{}</text>\n",
      at.x, at.y, style.size, anchor, style.weight == Weight::Bold ? " font-weight=\"bold\"" : "",
      style.halo
          ? " paint-order=\"stroke\" stroke=\"#fff\" stroke-opacity=\"0.9\" stroke-width=\"3.5\""
          : "",
      paint("fill", style.color), escaped(text));
}

/// Nobody knows the font here: the letters of DejaVu Sans are about so wide.
double Canvas::widthOf(const std::string& text, const TextStyle& style) {
  const double share = style.weight == Weight::Bold ? 0.68 : 0.6;
  const auto letters = std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
  return share * style.size * static_cast<double>(letters);
}

Canvas::View::View(Canvas& canvas, Point2 low, Point2 high, const Box2& world, double largestScale)
    : canvas_(canvas) {
  Surface& surface = canvas.surface_;
  ++surface.count;
  surface.add(
      "<clipPath id=\"c{0}\"><rect x=\"{1:.6g}\" y=\"{2:.6g}\" width=\"{3:.6g}\" "
      "height=\"{4:.6g}\"/>"
      "</clipPath>\n<g clip-path=\"url(#c{0})\">\n",
      surface.count, low.x, low.y, high.x - low.x, high.y - low.y);
  surface.view.fit(low, high, world, largestScale);
}

Canvas::View::~View() {
  canvas_.surface_.view = {};
  canvas_.surface_.svg += "</g>\n";
}

/// Begins an element; its attributes and its end follow.
void Canvas::path(const std::vector<Loop>& loops) {
  surface_.svg += "<path d=\"";
  for (const Loop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point2 p = pixel(loop[i]);
      surface_.add("{}{:.6g} {:.6g}", i == 0 ? "M" : "L", p.x, p.y);
    }
    surface_.svg += "Z";
  }
  surface_.svg += "\" ";
}

void Canvas::fill(const std::vector<Loop>& loops, Color color) {
  path(loops);
  surface_.add("{}/>\n", paint("fill", color));
}

void Canvas::stroke(const std::vector<Loop>& loops, Color color, double width, bool dashed) {
  path(loops);
  surface_.add("{}{}/>\n", strokeOf(color, width), dashed ? " stroke-dasharray=\"4\"" : "");
}

void Canvas::line(Point2 from, Point2 to, Color color, double width) {
  const Point2 p = pixel(from), q = pixel(to);
  surface_.add("<path d=\"M{:.6g} {:.6g}L{:.6g} {:.6g}\" {}/>\n", p.x, p.y, q.x, q.y,
               strokeOf(color, width));
}

void Canvas::arrow(Point2 from, Point2 to, Color color, double width) {
  line(from, to, color, width);
  const Loop head = arrowHead(pixel(from), pixel(to), width);
  if (head.empty()) return;
  const CanvasView view = std::exchange(surface_.view, {});  // the head is in pixels
  fill({head}, color);
  surface_.view = view;
}

void Canvas::band(Point2 from, Point2 to, Color color, double width) {
  const Point2 p = pixel(from), q = pixel(to);
  const double size = distance(p, q);
  if (size == 0) return;
  const Point2 aside = (width / size) * Point2{-(q.y - p.y), q.x - p.x};  // right, as y points down
  const int name = ++surface_.count;
  surface_.add(
      "<linearGradient id=\"g{}\" gradientUnits=\"userSpaceOnUse\" x1=\"{:.6g}\" y1=\"{:.6g}\" "
      "x2=\"{:.6g}\" y2=\"{:.6g}\"><stop {}/><stop offset=\"1\" {}/></linearGradient>\n",
      name, p.x, p.y, p.x + aside.x, p.y + aside.y,
      paint("stop", color).replace(0, 4, "stop-color"), "stop-opacity=\"0\"");
  const Point2 r = q + aside, s = p + aside;
  surface_.add(
      "<path d=\"M{:.6g} {:.6g}L{:.6g} {:.6g}L{:.6g} {:.6g}L{:.6g} {:.6g}Z\" "
      "fill=\"url(#g{})\"/>\n",
      p.x, p.y, q.x, q.y, r.x, r.y, s.x, s.y, name);
}

void Canvas::dot(Point2 at, double radius, Color fill, Color edge, double edgeWidth) {
  const Point2 p = pixel(at);
  surface_.add("<circle cx=\"{:.6g}\" cy=\"{:.6g}\" r=\"{:.4g}\" {} {} stroke-width=\"{:.4g}\"/>\n",
               p.x, p.y, radius, paint("fill", fill), paint("stroke", edge), edgeWidth);
}

void Canvas::cross(Point2 at, double radius, Color color, double width) {
  const Point2 p = pixel(at);
  surface_.add(
      "<path d=\"M{0:.6g} {1:.6g}L{2:.6g} {3:.6g}M{0:.6g} {3:.6g}L{2:.6g} {1:.6g}\" {4}/>\n",
      p.x - radius, p.y - radius, p.x + radius, p.y + radius, strokeOf(color, width));
}

}  // namespace af2::dsl::picture
