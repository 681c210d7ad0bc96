#include "geometry/picture/png_file.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "engine/base/error.h"
#include "engine/base/loaded_function.h"

namespace af2::geometry {
namespace {

constexpr LoadedLibrary kCairo{"libcairo.so.2", "pictures", "libcairo2"};
AF2_LOADED_FUNCTION(kCairo, cairo_create);
AF2_LOADED_FUNCTION(kCairo, cairo_destroy);
AF2_LOADED_FUNCTION(kCairo, cairo_fill);
AF2_LOADED_FUNCTION(kCairo, cairo_image_surface_create);
AF2_LOADED_FUNCTION(kCairo, cairo_image_surface_get_data);
AF2_LOADED_FUNCTION(kCairo, cairo_image_surface_get_stride);
AF2_LOADED_FUNCTION(kCairo, cairo_move_to);
AF2_LOADED_FUNCTION(kCairo, cairo_paint);
AF2_LOADED_FUNCTION(kCairo, cairo_pattern_add_color_stop_rgb);
AF2_LOADED_FUNCTION(kCairo, cairo_pattern_create_linear);
AF2_LOADED_FUNCTION(kCairo, cairo_pattern_destroy);
AF2_LOADED_FUNCTION(kCairo, cairo_rectangle);
AF2_LOADED_FUNCTION(kCairo, cairo_select_font_face);
AF2_LOADED_FUNCTION(kCairo, cairo_set_font_size);
AF2_LOADED_FUNCTION(kCairo, cairo_set_source);
AF2_LOADED_FUNCTION(kCairo, cairo_set_source_rgb);
AF2_LOADED_FUNCTION(kCairo, cairo_show_text);
AF2_LOADED_FUNCTION(kCairo, cairo_status);
AF2_LOADED_FUNCTION(kCairo, cairo_status_to_string);
AF2_LOADED_FUNCTION(kCairo, cairo_surface_destroy);
AF2_LOADED_FUNCTION(kCairo, cairo_surface_flush);
AF2_LOADED_FUNCTION(kCairo, cairo_surface_mark_dirty);
AF2_LOADED_FUNCTION(kCairo, cairo_surface_status);
AF2_LOADED_FUNCTION(kCairo, cairo_surface_write_to_png_stream);
AF2_LOADED_FUNCTION(kCairo, cairo_text_extents);

constexpr int kLegendHeight = 52;
constexpr double kLegendMargin = 24, kBarWidth = 220, kBarHeight = 14, kFontSize = 15;

struct Delete {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  void operator()(cairo_pattern_t* pattern) const { cairo_pattern_destroy(pattern); }
};
using Surface = std::unique_ptr<cairo_surface_t, Delete>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw InputError(std::string("the picture cannot be drawn: ") + cairo_status_to_string(status));
}

std::uint32_t pixelOf(const Rgb& color) {
  std::uint32_t pixel = 0;
  for (const double part : {color.red, color.green, color.blue})
    pixel = pixel << 8 | static_cast<std::uint32_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
  return pixel;
}

void copyPixels(const Raster& image, cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  unsigned char* const bytes = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < image.height(); ++y) {
    auto* const row =
        reinterpret_cast<std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < image.width(); ++x) row[x] = pixelOf(image.at(x, y));
  }
  cairo_surface_mark_dirty(surface);
}

void drawBar(cairo_t* cairo, double left, double top) {
  const std::unique_ptr<cairo_pattern_t, Delete> scale(
      cairo_pattern_create_linear(left, 0, left + kBarWidth, 0));
  for (std::size_t i = 0; i < kQualityColors.size(); ++i) {
    const auto& [red, green, blue] = kQualityColors[i];
    const double at = static_cast<double>(i) / static_cast<double>(kQualityColors.size() - 1);
    cairo_pattern_add_color_stop_rgb(scale.get(), at, red, green, blue);
  }
  cairo_rectangle(cairo, left, top, kBarWidth, kBarHeight);
  cairo_set_source(cairo, scale.get());
  cairo_fill(cairo);
}

/// Returns where the text ends.
double drawText(cairo_t* cairo, const std::string& text, double left, double baseline) {
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  cairo_move_to(cairo, left, baseline);
  cairo_show_text(cairo, text.c_str());
  return left + extents.x_advance;
}

void drawLegend(cairo_t* cairo, double top, const std::string& caption) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, kFontSize);
  const double barTop = top + 14, baseline = barTop + kBarHeight - 1;
  const auto useInk = [&] { cairo_set_source_rgb(cairo, 0.12, 0.16, 0.2); };
  useInk();
  const double bar = drawText(cairo, "Quality  0 ", kLegendMargin, baseline) + 2;
  drawBar(cairo, bar, barTop);
  useInk();
  const double end = drawText(cairo, " 1", bar + kBarWidth + 2, baseline);
  drawText(cairo, caption, end + 2 * kLegendMargin, baseline);
}

}  // namespace

std::string pngWithLegend(const Raster& image, const std::string& caption) {
  const int height = image.height() + kLegendHeight;
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width(), height));
  check(cairo_surface_status(surface.get()));
  {
    const std::unique_ptr<cairo_t, Delete> cairo(cairo_create(surface.get()));
    cairo_set_source_rgb(cairo.get(), 1, 1, 1);
    cairo_paint(cairo.get());
    copyPixels(image, surface.get());
    drawLegend(cairo.get(), image.height(), caption);
    check(cairo_status(cairo.get()));
  }
  std::string bytes;
  check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  return bytes;
}

}  // namespace af2::geometry
