#include "api/arena/pin_inputs.h"

#include <algorithm>

#include "api/arena/image.h"
#include "api/context/vector_math.h"

namespace weft::api {

template <class T>
size_t PinInputs<T>::vector_element(size_t slot, size_t component) const {
  return slot * static_cast<size_t>(backend_.info().vector_stride) + component * pitch_;
}

template <class T>
void PinInputs<T>::prepare(const ArenaInput& in, const MovingPins<T>& image) {
  slots_.clear();
  if (!image.of_block) return;
  const Counts counts = plan::counts_of(in.shape);
  int32_t* of_block = writable(image.of_block);
  std::fill_n(of_block, counts.particles / block_size, -1);
  int next = 0;
  for (const ClothRecord* cloth : in.cloths) {
    for (size_t p = 0; p < cloth->pins.size(); ++p) {
      if (!cloth->pins[p].can_move) continue;
      const int i =
          cloth->first() + static_cast<int>(cloth->cooked().storage(cloth->pins[p].vertex));
      int32_t& block = of_block[i / block_size];
      if (block < 0) block = next++;
      slots_.push_back({cloth, p, static_cast<size_t>(block * block_size + i % block_size)});
    }
  }
  motions_ = static_cast<size_t>(counts.motions);
  const size_t elements = static_cast<size_t>(next) * block_size;
  pitch_ = image.base.pitch;
  motion_.assign(elements, -1);
  base_.assign(vector_element(elements - 1, 2) + 1, T(0));
  glide_.assign(base_.size(), T(0));
  offsets_.resize(static_cast<size_t>(counts.motions * counts.substeps));
}

template <class T>
void PinInputs<T>::stage_pins() {
  for (const PinSlot& s : slots_) {
    const PinRecord& pin = s.cloth->pins[s.pin];
    const Vec3<T> at = narrow<T>(minus(pin.base, s.cloth->origin));
    const Vec3<T> by = narrow<T>(pin.gliding ? minus(pin.target, pin.base) : double3{0, 0, 0});
    const T base[3] = {at.x, at.y, at.z}, glide[3] = {by.x, by.y, by.z};
    for (size_t c = 0; c < 3; ++c) {
      base_[vector_element(s.slot, c)] = base[c];
      glide_[vector_element(s.slot, c)] = glide[c];
    }
    motion_[s.slot] =
        pin.motion < 0 ? 0 : static_cast<int32_t>(s.cloth->place.motions) + pin.motion;
  }
}

/// Motion 0 stands for none.
template <class T>
void PinInputs<T>::stage_motions(const ArenaInput& in, const FrameInput& input) {
  for (int k = 0; k < input.substeps; ++k) {
    Vec3<T>* row = offsets_.data() + size_t(k) * motions_;
    row[0] = {T(0), T(0), T(0)};
    const double time = input.time + (k + 1) * input.dt;
    for (const ClothRecord* cloth : in.cloths) {
      for (size_t m = 0; m < cloth->motions.size(); ++m) {
        row[size_t(cloth->place.motions) + m] = narrow<T>(motion_offset(cloth->motions[m], time));
      }
    }
  }
}

template <class T>
Status PinInputs<T>::upload(const ArenaInput& in, const FrameInput& input,
                            const MovingPins<T>& device) {
  if (slots_.empty()) return Status::ok;
  stage_pins();
  stage_motions(in, input);
  const struct {
    const void* to;
    const void* from;
    size_t bytes;
  } uploads[] = {
      {device.base.data, base_.data(), base_.size() * sizeof(T)},
      {device.glide.data, glide_.data(), glide_.size() * sizeof(T)},
      {device.motion, motion_.data(), motion_.size() * sizeof(int32_t)},
      {device.offset, offsets_.data(), size_t(input.substeps) * motions_ * sizeof(Vec3<T>)},
  };
  for (const auto& u : uploads) {
    const Status status = backend_.to_device(const_cast<void*>(u.to), u.from, u.bytes);
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

template class PinInputs<float>;
template class PinInputs<double>;

}  // namespace weft::api
