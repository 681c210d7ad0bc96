#include "dsl/picture/canvas.h"

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>

#include "dsl/picture/canvas_view.h"
#include "engine/base/error.h"
#include "engine/base/loaded_function.h"

namespace af2::dsl::picture {
namespace {

constexpr LoadedLibrary kCairo{"libcairo.so.2", "pictures", "libcairo2"};
AF2_LOADED_FUNCTION(kCairo, cairo_arc);
AF2_LOADED_FUNCTION(kCairo, cairo_clip);
AF2_LOADED_FUNCTION(kCairo, cairo_close_path);
AF2_LOADED_FUNCTION(kCairo, cairo_create);
AF2_LOADED_FUNCTION(kCairo, cairo_destroy);
AF2_LOADED_FUNCTION(kCairo, cairo_fill);
AF2_LOADED_FUNCTION(kCairo, cairo_fill_preserve);
AF2_LOADED_FUNCTION(kCairo, cairo_image_surface_create);
AF2_LOADED_FUNCTION(kCairo, cairo_line_to);
AF2_LOADED_FUNCTION(kCairo, cairo_move_to);
AF2_LOADED_FUNCTION(kCairo, cairo_new_path);
AF2_LOADED_FUNCTION(kCairo, cairo_paint);
AF2_LOADED_FUNCTION(kCairo, cairo_pattern_add_color_stop_rgba);
AF2_LOADED_FUNCTION(kCairo, cairo_pattern_create_linear);
AF2_LOADED_FUNCTION(kCairo, cairo_pattern_destroy);
AF2_LOADED_FUNCTION(kCairo, cairo_rectangle);
AF2_LOADED_FUNCTION(kCairo, cairo_restore);
AF2_LOADED_FUNCTION(kCairo, cairo_save);
AF2_LOADED_FUNCTION(kCairo, cairo_scale);
AF2_LOADED_FUNCTION(kCairo, cairo_select_font_face);
AF2_LOADED_FUNCTION(kCairo, cairo_set_dash);
AF2_LOADED_FUNCTION(kCairo, cairo_set_font_size);
AF2_LOADED_FUNCTION(kCairo, cairo_set_line_cap);
AF2_LOADED_FUNCTION(kCairo, cairo_set_line_join);
AF2_LOADED_FUNCTION(kCairo, cairo_set_line_width);
AF2_LOADED_FUNCTION(kCairo, cairo_set_source);
AF2_LOADED_FUNCTION(kCairo, cairo_set_source_rgb);
AF2_LOADED_FUNCTION(kCairo, cairo_set_source_rgba);
AF2_LOADED_FUNCTION(kCairo, cairo_show_text);
AF2_LOADED_FUNCTION(kCairo, cairo_status);
AF2_LOADED_FUNCTION(kCairo, cairo_status_to_string);
AF2_LOADED_FUNCTION(kCairo, cairo_stroke);
AF2_LOADED_FUNCTION(kCairo, cairo_surface_destroy);
AF2_LOADED_FUNCTION(kCairo, cairo_surface_finish);
AF2_LOADED_FUNCTION(kCairo, cairo_surface_status);
AF2_LOADED_FUNCTION(kCairo, cairo_surface_write_to_png_stream);
AF2_LOADED_FUNCTION(kCairo, cairo_svg_surface_create_for_stream);
AF2_LOADED_FUNCTION(kCairo, cairo_svg_surface_set_document_unit);
AF2_LOADED_FUNCTION(kCairo, cairo_text_extents);
AF2_LOADED_FUNCTION(kCairo, cairo_text_path);

constexpr double kPngScale = 2;  // pixels of the file per pixel of the picture
const char* const kFont = "DejaVu Sans";

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

struct Delete {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};

/// Cairo numbers its surfaces per process. This removes the number, so that equal pictures give
/// equal files.
void dropSurfaceNumber(std::string& svg) {
  const std::string attribute = " id=\"surface";
  const std::size_t begin = svg.find(attribute);
  if (begin == std::string::npos) return;
  const std::size_t end = svg.find('"', begin + attribute.size());
  if (end != std::string::npos) svg.erase(begin, end + 1 - begin);
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw InputError(std::string("the picture cannot be drawn: ") + cairo_status_to_string(status));
}

}  // namespace

struct Canvas::Surface {
  cairo_t* cairo;
  CanvasView view;

  void use(Color c) { cairo_set_source_rgba(cairo, c.red, c.green, c.blue, c.alpha); }
};

std::string Canvas::render(PictureFormat format, double width, double height,
                           const std::function<void(Canvas&)>& draw) {
  std::string bytes;
  const bool isSvg = format == PictureFormat::Svg;
  const std::unique_ptr<cairo_surface_t, Delete> surface(
      isSvg ? cairo_svg_surface_create_for_stream(append, &bytes, width, height)
            : cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                         static_cast<int>(std::ceil(kPngScale * width)),
                                         static_cast<int>(std::ceil(kPngScale * height))));
  check(cairo_surface_status(surface.get()));
  if (isSvg) cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  {
    const std::unique_ptr<cairo_t, Delete> cairo(cairo_create(surface.get()));
    if (!isSvg) cairo_scale(cairo.get(), kPngScale, kPngScale);
    cairo_set_source_rgb(cairo.get(), 1, 1, 1);
    cairo_paint(cairo.get());
    cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo.get(), CAIRO_LINE_CAP_ROUND);
    Surface drawing{cairo.get(), {}};
    Canvas canvas(drawing);
    draw(canvas);
    check(cairo_status(cairo.get()));
  }
  if (!isSvg) check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  if (isSvg) dropSurfaceNumber(bytes);
  return bytes;
}

Point2 Canvas::pixel(Point2 p) const { return surface_.view.pixel(p); }

// --- pixels

namespace {
void roundedRectangle(cairo_t* cairo, Point2 low, Point2 high, double r) {
  cairo_new_path(cairo);
  cairo_arc(cairo, high.x - r, low.y + r, r, -M_PI / 2, 0);
  cairo_arc(cairo, high.x - r, high.y - r, r, 0, M_PI / 2);
  cairo_arc(cairo, low.x + r, high.y - r, r, M_PI / 2, M_PI);
  cairo_arc(cairo, low.x + r, low.y + r, r, M_PI, 1.5 * M_PI);
  cairo_close_path(cairo);
}

void setFont(cairo_t* cairo, const TextStyle& style) {
  cairo_select_font_face(
      cairo, kFont, CAIRO_FONT_SLANT_NORMAL,
      style.weight == Weight::Bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, style.size);
}
}  // namespace

void Canvas::fillRectangle(Point2 low, Point2 high, double radius, Color fill) {
  roundedRectangle(surface_.cairo, low, high, radius);
  surface_.use(fill);
  cairo_fill(surface_.cairo);
}

void Canvas::strokeRectangle(Point2 low, Point2 high, double radius, Color stroke, double width) {
  roundedRectangle(surface_.cairo, low, high, radius);
  surface_.use(stroke);
  cairo_set_line_width(surface_.cairo, width);
  cairo_stroke(surface_.cairo);
}

void Canvas::text(const std::string& text, Point2 at, const TextStyle& style) {
  cairo_t* cairo = surface_.cairo;
  setFont(cairo, style);
  if (style.anchor != Anchor::Left)
    at.x -= widthOf(text, style) * (style.anchor == Anchor::Middle ? 0.5 : 1);
  cairo_new_path(cairo);
  if (style.halo) {
    cairo_move_to(cairo, at.x, at.y);
    cairo_text_path(cairo, text.c_str());
    cairo_set_source_rgba(cairo, 1, 1, 1, 0.9);
    cairo_set_line_width(cairo, 3.5);
    cairo_stroke(cairo);
  }
  cairo_move_to(cairo, at.x, at.y);
  surface_.use(style.color);
  cairo_show_text(cairo, text.c_str());
  cairo_new_path(cairo);
}

double Canvas::widthOf(const std::string& text, const TextStyle& style) {
  setFont(surface_.cairo, style);
  cairo_text_extents_t extents;
  cairo_text_extents(surface_.cairo, text.c_str(), &extents);
  return extents.x_advance;
}

// --- the chart

Canvas::View::View(Canvas& canvas, Point2 low, Point2 high, const Box2& world, double largestScale)
    : canvas_(canvas) {
  Surface& surface = canvas.surface_;
  cairo_save(surface.cairo);
  cairo_rectangle(surface.cairo, low.x, low.y, high.x - low.x, high.y - low.y);
  cairo_clip(surface.cairo);
  surface.view.fit(low, high, world, largestScale);
}

Canvas::View::~View() {
  canvas_.surface_.view = {};
  cairo_restore(canvas_.surface_.cairo);
}

void Canvas::path(const std::vector<Loop>& loops) {
  cairo_new_path(surface_.cairo);
  for (const Loop& loop : loops) {
    for (const Point2 corner : loop) {
      const Point2 p = pixel(corner);
      cairo_line_to(surface_.cairo, p.x, p.y);
    }
    cairo_close_path(surface_.cairo);
  }
}

void Canvas::fill(const std::vector<Loop>& loops, Color color) {
  path(loops);
  surface_.use(color);
  cairo_fill(surface_.cairo);
}

void Canvas::stroke(const std::vector<Loop>& loops, Color color, double width, bool dashed) {
  path(loops);
  surface_.use(color);
  cairo_set_line_width(surface_.cairo, width);
  const double dashes[] = {4, 4};
  cairo_set_dash(surface_.cairo, dashes, dashed ? 2 : 0, 0);
  cairo_stroke(surface_.cairo);
  cairo_set_dash(surface_.cairo, nullptr, 0, 0);
}

void Canvas::line(Point2 from, Point2 to, Color color, double width) {
  const Point2 p = pixel(from), q = pixel(to);
  surface_.use(color);
  cairo_set_line_width(surface_.cairo, width);
  cairo_new_path(surface_.cairo);
  cairo_move_to(surface_.cairo, p.x, p.y);
  cairo_line_to(surface_.cairo, q.x, q.y);
  cairo_stroke(surface_.cairo);
}

void Canvas::arrow(Point2 from, Point2 to, Color color, double width) {
  line(from, to, color, width);
  const Loop head = arrowHead(pixel(from), pixel(to), width);
  if (head.empty()) return;
  cairo_new_path(surface_.cairo);
  for (const Point2 corner : head) cairo_line_to(surface_.cairo, corner.x, corner.y);
  cairo_close_path(surface_.cairo);
  cairo_fill(surface_.cairo);
}

void Canvas::band(Point2 from, Point2 to, Color color, double width) {
  const Point2 p = pixel(from), q = pixel(to);
  const double size = distance(p, q);
  if (size == 0) return;
  const Point2 aside = (width / size) * Point2{-(q.y - p.y), q.x - p.x};  // right, as y points down
  cairo_pattern_t* gradient = cairo_pattern_create_linear(p.x, p.y, p.x + aside.x, p.y + aside.y);
  cairo_pattern_add_color_stop_rgba(gradient, 0, color.red, color.green, color.blue, color.alpha);
  cairo_pattern_add_color_stop_rgba(gradient, 1, color.red, color.green, color.blue, 0);
  cairo_set_source(surface_.cairo, gradient);
  cairo_pattern_destroy(gradient);
  cairo_new_path(surface_.cairo);
  for (const Point2 corner : {p, q, q + aside, p + aside})
    cairo_line_to(surface_.cairo, corner.x, corner.y);
  cairo_close_path(surface_.cairo);
  cairo_fill(surface_.cairo);
}

void Canvas::dot(Point2 at, double radius, Color fill, Color edge, double edgeWidth) {
  const Point2 p = pixel(at);
  cairo_new_path(surface_.cairo);
  cairo_arc(surface_.cairo, p.x, p.y, radius, 0, 2 * M_PI);
  surface_.use(fill);
  cairo_fill_preserve(surface_.cairo);
  surface_.use(edge);
  cairo_set_line_width(surface_.cairo, edgeWidth);
  cairo_stroke(surface_.cairo);
}

void Canvas::cross(Point2 at, double radius, Color color, double width) {
  const Point2 p = pixel(at);
  surface_.use(color);
  cairo_set_line_width(surface_.cairo, width);
  cairo_new_path(surface_.cairo);
  for (const double s : {-1.0, 1.0}) {
    cairo_move_to(surface_.cairo, p.x - radius, p.y - s * radius);
    cairo_line_to(surface_.cairo, p.x + radius, p.y + s * radius);
  }
  cairo_stroke(surface_.cairo);
}

}  // namespace af2::dsl::picture
