// A frame of particles that meet each other: calls of the back end until it is worth something.
#pragma once

#include "api/arena/contacts.h"
#include "api/arena/vectors.h"

namespace weft::api {

/// To the start of the frame, which is `start` with displacements (or previous positions) in `d`.
/// What sleepers have in the other buffers is the same; who was touched, and what left its range,
/// may have been so only in what is forgotten now.
template <class T>
Status return_to_start(const Backend& backend, const Simulation<T>& start, const Vec3Array<T>& d,
                       ContactTables<T>& contacts, Frame<T>& frame) {
  const Contacts<T> now = frame.sim.contacts;
  frame.sim = start;
  frame.sim.contacts = now;
  frame.begin = 0;
  contacts.forget_motion();
  Status status = copy_vectors(backend, now.start_x, start.x[0], start.blocks);
  if (status == Status::ok) status = copy_vectors(backend, now.start_d, d, start.blocks);
  if (status == Status::ok) status = contacts.forget_touched(start);
  if (status == Status::ok && start.edges.overflow) {
    status = backend.to_device(start.edges.overflow, &no_overflow, sizeof no_overflow);
  }
  return status;
}

/// A frame that is gone on with when its list of pairs has got more room, or made again where
/// nobody could look at the lists; without memory for them the frame has not been.
template <class T>
Status frame_with_contact(const Backend& backend, ContactTables<T>& contacts, Frame<T>& frame) {
  const Simulation<T> start = frame.sim;
  const Vec3Array<T> d = frame.position_form ? start.x[2] : start.d[0];
  Status status = copy_vectors(backend, start.x[0], start.contacts.start_x, start.blocks);
  if (status == Status::ok) {
    status = copy_vectors(backend, d, start.contacts.start_d, start.blocks);
  }
  FrameVerdict verdict = FrameVerdict::to_go_on;
  while (status == Status::ok && verdict != FrameVerdict::done) {
    contacts.give_age(frame);
    status = backend.frame(frame);
    contacts.take_age(frame);
    if (status == Status::ok) status = contacts.judge(frame, verdict);
    if (status == Status::ok && verdict == FrameVerdict::to_make_again) {
      status = return_to_start(backend, start, d, contacts, frame);
    }
  }
  if (status == Status::out_of_memory) return_to_start(backend, start, d, contacts, frame);
  return status;
}

}  // namespace weft::api
