// The executor's contract, against independent host code.
#include <algorithm>
#include <cstring>
#include <numeric>

#include <gtest/gtest.h>

#include "reference/random.h"

#include "backends.h"

namespace weft::testing {
namespace {

/// The fixed tree, written as design describes it: leaves of 1024 in 32 lane sums, halved.
template <class T>
T tree_sum(std::vector<T> values) {
  do {
    std::vector<T> leaves;
    for (size_t first = 0; first < std::max<size_t>(values.size(), 1); first += 1024) {
      T lane[32] = {};
      for (size_t i = first; i < std::min(first + 1024, values.size()); ++i)
        lane[(i - first) % 32] += values[i];
      for (int half : {16, 8, 4, 2, 1}) {
        for (int l = 0; l < half; ++l) lane[l] += lane[l + half];
      }
      leaves.push_back(lane[0]);
    }
    values.swap(leaves);
  } while (values.size() > 1);
  return values[0];
}

/// Device memory with the contents of a vector.
template <class T>
class DeviceArray {
 public:
  DeviceArray(const Backend& backend, const std::vector<T>& values)
      : backend_(backend), bytes_(std::max<size_t>(values.size(), 1) * sizeof(T)) {
    data_ = static_cast<T*>(backend_.allocate({}, bytes_));
    EXPECT_EQ(backend_.to_device(data_, values.data(), values.size() * sizeof(T)), Status::ok);
  }
  ~DeviceArray() { backend_.release({}, data_, bytes_); }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;

  T* data() const { return data_; }
  std::vector<T> read(size_t count) const {
    std::vector<T> out(count);
    EXPECT_EQ(backend_.to_host(out.data(), data_, count * sizeof(T)), Status::ok);
    return out;
  }

 private:
  const Backend& backend_;
  size_t bytes_;
  T* data_;
};

class Contract : public ::testing::TestWithParam<NamedBackend> {
 protected:
  const Backend& backend() const { return *GetParam().backend; }

  template <class T>
  void expect_tree_sums() {
    reference::SplitMix random(7);
    for (const int count : {0, 1, 31, 32, 33, 1023, 1024, 1025, 99999, 1 << 21}) {
      std::vector<T> values;
      for (int i = 0; i < count; ++i) values.push_back(T(random.uniform() - 0.3));
      const DeviceArray<T> device(backend(), values);
      const DeviceArray<T> scratch(backend(), std::vector<T>(reduce_scratch(size_t(count))));
      const T expected = tree_sum(values);
      for (const int threads : {1, 2, 3, 5, 8}) {
        T sum = -1;
        ASSERT_EQ(backend().sum(device.data(), count, scratch.data(), threads, sum), Status::ok);
        EXPECT_EQ(std::memcmp(&sum, &expected, sizeof sum), 0)
            << count << " values, " << threads << " threads: " << sum << ", not " << expected;
      }
    }
  }
};

TEST_P(Contract, ReduceGivesTheBitsOfTheFixedTreeForAnyThreadCount) {
  expect_tree_sums<float>();
  expect_tree_sums<double>();
}

TEST_P(Contract, ExclusiveScanSumsWhatIsBefore) {
  reference::SplitMix random(3);
  for (const size_t count : {size_t(0), size_t(1), size_t(1000), size_t(300007)}) {
    std::vector<uint32_t> values;
    for (size_t i = 0; i < count; ++i) values.push_back(uint32_t(random.bits() % 1000));
    std::vector<uint32_t> expected(count);
    std::exclusive_scan(values.begin(), values.end(), expected.begin(), 0u);
    const DeviceArray<uint32_t> in(backend(), values), out(backend(), values);
    ASSERT_EQ(backend().exclusive_scan(in.data(), out.data(), int(count), 2), Status::ok);
    EXPECT_EQ(out.read(count), expected);
    ASSERT_EQ(backend().exclusive_scan(in.data(), in.data(), int(count), 2), Status::ok);
    EXPECT_EQ(in.read(count), expected);
  }
}

TEST_P(Contract, SortKeepsTheOrderOfEqualKeys) {
  reference::SplitMix random(9);
  const size_t count = 200000;
  std::vector<uint32_t> keys, values(count), order(count);
  for (size_t i = 0; i < count; ++i) keys.push_back(uint32_t(random.bits() % 500));
  std::iota(values.begin(), values.end(), 0u);
  order = values;
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return keys[a] < keys[b]; });
  const DeviceArray<uint32_t> k(backend(), keys), v(backend(), values);
  ASSERT_EQ(backend().stable_sort_by_key(k.data(), v.data(), int(count), 2), Status::ok);
  EXPECT_EQ(v.read(count), order);
}

INSTANTIATE_TEST_SUITE_P(Every, Contract, ::testing::ValuesIn(backends()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace weft::testing
