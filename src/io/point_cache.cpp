#include "io/point_cache.h"

#include "io/error.h"
#include "io/file_text.h"
#include "io/little_endian.h"
#include "io/text_cursor.h"

#include <cmath>

namespace weft::io {
namespace {

constexpr std::string_view magic("POINTCACHE2\0", 12);
constexpr size_t header_size = 32, samples_offset = 28, point_size = 12;

[[noreturn]] void fail(const std::string& name, const std::string& problem) {
  throw InputError(name + ": " + problem);
}

uint32_t count_at(std::string_view bytes, size_t offset, const char* what,
                  const std::string& name) {
  const auto count = get_little<int32_t>(bytes.data() + offset);
  if (count < 0) {
    fail(name, std::string("the number of ") + what + ", " + std::to_string(count) +
                   ", is negative (it counts them) correct it");
  }
  return uint32_t(count);
}

PointCache read_header(std::string_view bytes, const std::string& name) {
  if (bytes.substr(0, magic.size()) != magic) {
    fail(name, "does not start with 'POINTCACHE2' and a zero byte (a PC2 file does) give one");
  }
  if (bytes.size() < header_size) {
    fail(name, "has " + std::to_string(bytes.size()) + " bytes (the header alone has " +
                   std::to_string(header_size) + ") give the whole file");
  }
  const auto version = get_little<int32_t>(bytes.data() + 12);
  if (version != 1) {
    fail(name,
         "has version " + std::to_string(version) + " (only 1 is known) save it as version 1");
  }
  PointCache cache;
  cache.points = count_at(bytes, 16, "points", name);
  cache.start = get_little<float>(bytes.data() + 20);
  cache.rate = get_little<float>(bytes.data() + 24);
  cache.samples = count_at(bytes, samples_offset, "samples", name);
  if (!std::isfinite(cache.start)) {
    fail(name, "the first frame, " + number_text(double(cache.start)) +
                   ", is not finite (samples have a time) correct it");
  }
  if (!std::isfinite(cache.rate) || !(cache.rate > 0)) {
    fail(name, "the sample rate, " + number_text(double(cache.rate)) +
                   ", is out of range (it is samples per frame) give a finite number > 0");
  }
  return cache;
}

size_t checked(size_t points, const std::string& path) {
  if (points <= size_t(INT32_MAX)) return points;
  throw OutputError(path + ": " + std::to_string(points) +
                    " points are too many (PC2 counts to 2147483647) write ply");
}

}  // namespace

PointCache read_point_cache(const std::string& path) {
  return read_point_cache(read_file(path, largest_mesh_file()).view(), path);
}

PointCache read_point_cache(std::string_view bytes, const std::string& name) {
  PointCache cache = read_header(bytes, name);
  const uint64_t count = uint64_t(cache.points) * cache.samples;  // below 2^62
  const uint64_t body = bytes.size() - header_size;
  if (body / point_size < count || body - point_size * count != 0) {
    fail(name, "has " + std::to_string(body) + " bytes behind the header (" +
                   std::to_string(cache.samples) + " samples of " + std::to_string(cache.points) +
                   " points take 12 times " + std::to_string(count) + ") give the whole file");
  }
  cache.positions.resize(count);
  const char* at = bytes.data() + header_size;
  for (size_t i = 0; i < count; ++i, at += point_size) {
    cache.positions[i] = {get_little<float>(at), get_little<float>(at + 4),
                          get_little<float>(at + 8)};
    const float3& p = cache.positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      fail(name, "sample " + std::to_string(i / cache.points) + ", point " +
                     std::to_string(i % cache.points) +
                     " is not finite (positions are) correct it");
    }
  }
  return cache;
}

PointCacheWriter::PointCacheWriter(const std::string& path, size_t points, float start, float rate)
    : path_(path), file_(path), points_(checked(points, path)), record_(points_ * point_size) {
  char header[header_size];
  char* at = std::copy(magic.begin(), magic.end(), header);
  at = put_little(at, int32_t(1));
  at = put_little(at, int32_t(points));
  at = put_little(at, start);
  at = put_little(at, rate);
  put_little(at, int32_t(0));  // until commit
  file_.write(header, sizeof header);
}

void PointCacheWriter::add(const double3* positions) {
  if (samples_ == uint32_t(INT32_MAX)) {
    throw OutputError(path_ +
                      ": has 2147483647 samples (PC2 counts no further) write fewer frames");
  }
  char* at = record_.data();
  for (size_t i = 0; i < points_; ++i) {
    for (const double value : {positions[i].x, positions[i].y, positions[i].z}) {
      at = put_little(at, static_cast<float>(value));
    }
  }
  file_.write(record_.data(), record_.size());
  ++samples_;
}

void PointCacheWriter::commit() {
  char count[4];
  put_little(count, int32_t(samples_));
  file_.overwrite(samples_offset, {count, sizeof count});
  file_.commit();
}

}  // namespace weft::io
