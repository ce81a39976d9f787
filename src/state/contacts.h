// Contact of particles with each other: which cells they lie in, which pairs are near, and how far
// the near ones push each other.
//
// All cloths of a world are searched together. Cells and distances are of the world; positions
// stay local to their cloths.
#pragma once

#include "base/view.h"
#include "state/counts.h"

namespace weft {

/// How often particles in contact are put apart in a substep: each time hands what presses on them
/// on by a layer.
constexpr int contact_passes = 4;

enum class Search : int32_t { none, complete, staggered };
constexpr int most_grids = 64;

/// What a cloth has to do with contact.
struct ContactCloth {
  double origin[3];   ///< m: of its local positions
  double distance;    ///< m
  double wake_speed;  ///< m/s: asleep, what touches it faster than this wakes it
  uint32_t layers;
  int32_t itself, others;  ///< 1: its particles meet each other, those of other cloths
};

/// Of a block: bounds of the positions (world), of the displacements, and of the skins.
struct ContactBox {
  double low[3], high[3], slowest[3], fastest[3];
  double most_skin;  ///< m
};

/// Bounds of the drifts and skins of the particles in a part of space, so that who is calm and
/// among calm ones need not look as far as who is not. Doubles in the order of unsigned integers.
struct ContactZone {
  unsigned long long slowest[3], fastest[3], most_skin;
};
constexpr int zone_bits = 4, contact_zones = 1 << (3 * zone_bits);  ///< along an axis; all

/// Scalars of the search that live on the device: one element.
struct ContactState {
  double low[3];           ///< m: where cell 0 begins
  double inverse_cell[3];  ///< 1/m
  double inverse_zone[3];  ///< 1/m
  double reach[3];         ///< m: no pair of the list is further apart along an axis
  uint32_t mask[3];        ///< of the cell's number along an axis, before
  int32_t shift[3];        ///< it is put into the key
  double calm[3];          ///< m: the least displacement of a substep among all
  double slack;            ///< m: what rounding may make of a distance
  int32_t horizon;         ///< substeps that the list is made for; 0: of these positions alone
  int32_t limit;           ///< most substeps that a list is tried for; where the host cannot see
                           ///< (Team::sees) the most that the last one could have been made for
  int32_t wait, backoff;   ///< substeps without a list that outlives them, and the next such time
  unsigned long long outrun;  ///< 1: a particle is not where its list expects it
  unsigned long long used;    ///< entries of the list that were wanted
  unsigned long long most;    ///< of all lists of a frame; where the host sees, since the start
  unsigned long long lists;   ///< made so far

  // Groups of particles (ContactGroups).
  double pace[3];                   ///< m: what particles went in a substep on average
  unsigned long long least_left;    ///< m: of all pairs of groups after `ahead` substeps as before,
                                    ///< as an ordered double
  unsigned long long least_beyond;  ///< m: of all blocks: margin - path, so too
  unsigned long long most_pace;     ///< m: from the average in a substep, so too
  unsigned long long least_ahead;   ///< m: so too, after `ahead` substeps as before
  int32_t span;                     ///< substeps that the last motion of groups took
  int32_t quiet;                    ///< 1: nothing touched at the last look
  int32_t ahead;                    ///< substeps that are tried without a look
  int32_t hold, holds;              ///< looks before the next try; of the last try that failed
  double budget;                    ///< m: that a particle may go meanwhile from what is expected
  double part;                      ///< of the usual margins
  int32_t pair_horizon;             ///< substeps that pairs of groups are made for
  uint64_t paired;                  ///< substep that they were made in
  unsigned long long pairs;         ///< of groups that were wanted
  unsigned long long moved[2];      ///< the last substep in which a particle went too far, by turns
  unsigned long long looks;         ///< into pairs of groups, by groups that look into many
  unsigned long long crowded;       ///< 1: too many pairs of groups
  uint64_t crowded_until;           ///< substep that groups are tried in again
  int32_t restless;                 ///< how often pairs of groups did not last, one after the other
  int32_t crowd_backoff;            ///< the next such time, in 64 substeps
};

/// What colliders do in a substep of particles that meet each other: in blocks with a row in the
/// list, in all blocks, or in none they wait for contact.
enum class Waits : int32_t { listed, every, none };

/// Particles that follow each other in memory, eight together: pairs of groups that are near, each
/// with the way that their particles have until two of them can touch. Only the pairs that have
/// none left are looked into.
constexpr int contact_group = 8;
constexpr int groups_a_block = block_size / contact_group;

template <class T>
struct ContactGroups {
  int64_t capacity;          ///< pairs: in one half those that are, in the other those that were
  double *low[3], *high[3];  ///< m: by group, where it is in the world
  double* speed[3];          ///< m a substep: by group, as it is expected to go on
  double* block_box;         ///< m: low and high x, y, z by turns of where each block comes by
  double* super_box;         ///< the same of 32 blocks
  T* motion[4];    ///< m: x, y, z that a group went since it was looked at, and at most from that
  double* path;    ///< m: by group, that it went from what was expected since pairs were made
  double* margin;  ///< m: by group, that it may go so
  double* usual;   ///< m: by group, that it went so in a substep
  int64_t* pair_start;
  int32_t* pair_count;  ///< by group, a multiple of 8: filled up with groups that never touch
  int32_t* other;       ///< by pair: group
  T* left;              ///< m: by pair; below zero: two may touch
  uint64_t* apart;      ///< by pair: bit 8 j + i: particle i, and j of the other, never meet

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    const int64_t blocks = n.contact_groups ? n.particles / block_size : 0;
    const int64_t groups = blocks * groups_a_block, pairs = 2 * groups * most_pairs_a_group;
    array.number(capacity, pairs);
    array(low[0], groups);
    array(low[1], groups);
    array(low[2], groups);
    array(high[0], groups);
    array(high[1], groups);
    array(high[2], groups);
    array(speed[0], groups);
    array(speed[1], groups);
    array(speed[2], groups);
    array(block_box, 6 * blocks);
    array(super_box, 6 * ((blocks + 31) / 32));
    array(motion[0], groups);
    array(motion[1], groups);
    array(motion[2], groups);
    array(motion[3], groups);
    array(path, groups);
    array(margin, groups);
    array(usual, groups);
    array(pair_start, groups);
    array(pair_count, groups);
    array(other, pairs);
    array(left, pairs);
    array(apart, pairs);
  }

  static constexpr int most_pairs_a_group = 48;  ///< on average
};

/// How a list is made: of the pairs that are near now, or that may be within `horizon` substeps.
/// With a skin every pair that is nearer than its distance and the skins of both while each
/// particle goes on by its `drift`. Who is further than a skin from there has outrun the list.
template <class T>
struct Contacts {
  ContactState* state;  ///< null: no cloth meets another, or itself
  Search search;
  int32_t grids, window;
  double cell;            ///< m: of Search::staggered
  double shift[3];        ///< m: of its grid at hand
  int32_t diagonal;       ///< its shifts go along (1,1,1)
  double skin;            ///< m: of a particle that goes its way; 0: no list outlives a substep
  double most_distance;   ///< m: of all cloths
  double most_stop;       ///< m: that the skin grows by of who may be stopped
  double most_drift;      ///< m: that particles drift apart at most while a list lasts
  T friction;             ///< coefficient of Coulomb friction
  int32_t with_excluded;  ///< 1: pairs whose rest distance is too short are listed too
  int32_t by_groups;      ///< 1: a host looks at groups of particles where it can
  Waits waits;            ///< what colliders do
  T age;                  ///< substeps since the list was made, the one at hand included
  T still;                ///< substeps since groups were looked at, so too, of those that their
                          ///< motion took; 0: nobody asks
  T budget;               ///< m: that a particle may go meanwhile from where its group would be
  T onward;               ///< of the groups' last motion, that is expected without a look
  T early;                ///< m: pairs of groups that would have less left then are looked into
  uint64_t substep;       ///< number of the one at hand
  const ContactCloth* cloth;
  int32_t cloths;
  const uint32_t* rank;       ///< by particle: in the caller's order, over all cloths
  const double* rest;         ///< rest positions: x, y, z by turns
  unsigned long long* woken;  ///< by cloth: 1 when something fast touches the sleeper

  // The search. Sorted arrays have a block more than there are particles.
  ContactBox* box;  ///< by block
  ContactZone* zone;
  int32_t key_bits;         ///< of a key; the largest one stands for padding
  int32_t entries_a_grid;   ///< of the sorted arrays of a grid
  uint32_t *key, *element;  ///< sorted; of every grid
  uint32_t* room;           ///< for the sort of a grid
  int64_t room_words;       ///< of it
  uint32_t* place;          ///< Search::staggered: where an element is in the order of every grid
  uint32_t* cell_start;     ///< by key, and one more
  Vec3Array<T> spot, drift_of_spot;  ///< sorted: position from state->low, displacement
  T* radius_of_spot;                 ///< m: half the distance, and the skin
  int32_t* cloth_of_spot;

  // The list: rows of 32 particles, as wide as the longest, filled up with the particle itself.
  int64_t* row_start;        ///< by block: first entry
  int32_t* row_width;        ///< by block; 0: nothing near
  int32_t* row_foreign;      ///< by block: 1 where another cloth is near
  int32_t* entry;            ///< by ascending rank; memory of its own
  T* impulse;                ///< kg m: by entry, what the pair has given each other's
                             ///< displacement in a substep; below zero: the two do not touch
  int64_t capacity;          ///< entries that it has room for
  Vec3Array<T> from, drift;  ///< where each particle was, and went in a substep, at that time
  T* skin_of;                ///< m: how far it may be from where it would be so

  Vec3Array<T> start_x, start_d;  ///< before a frame, for one that cannot be finished

  // Response.
  int32_t* touching;           ///< by particle: partners
  Vec3Array<T> push, brake;    ///< what is added to the position, to the displacement
  Vec3Array<T> shift_of_form;  ///< position form: of push, what must not become displacement
  Vec3Array<T> first;          ///< positions before any push of the substep, or when the groups
                               ///< were looked at
  int32_t* busy;               ///< by block: pairs that touch, of its particles
  int32_t* coincide;           ///< of them, those at one place before any push
  ContactGroups<T> groups;

  template <class Arrays>
  constexpr void arrays(Arrays& array, const Counts& n) {
    const int64_t particles = n.contact_grids > 0 ? n.particles : 0;
    const int64_t blocks = particles / block_size;
    const bool lists = n.contact_grids > 0 && !n.staggered;
    const int64_t sorted = particles > 0 ? particles + block_size : 0;
    array(state, particles > 0 ? 1 : 0);
    array(cloth, particles > 0 ? n.cloths : 0);
    array(rank, particles);
    array(rest, 3 * particles);
    array(woken, particles > 0 ? n.cloths : 0);
    array(box, blocks);
    array(zone, lists ? contact_zones : 0);
    array.number(cloths, n.cloths);
    array.number(key_bits, n.key_bits);
    array.number(entries_a_grid, sorted);
    array(key, n.contact_grids * sorted);
    array(element, n.contact_grids * sorted);
    // As much as is sorted, and what the sorts of GPUs count in.
    const int64_t words = sorted > 0 ? 2 * sorted + sorted / 8 + 8192 : 0;
    array(room, words);
    array.number(room_words, words);
    array(place, n.staggered ? n.contact_grids * sorted : 0);
    array(cell_start, lists ? (int64_t(1) << n.key_bits) + 2 : 0);
    array(spot, sorted);
    array(drift_of_spot, lists ? sorted : 0);
    array(radius_of_spot, sorted);
    array(cloth_of_spot, lists ? sorted : 0);
    array(row_start, blocks);
    array(row_width, blocks);
    array(row_foreign, blocks);
    array(from, lists ? particles : 0);
    array(drift, lists ? particles : 0);
    array(skin_of, lists ? particles : 0);
    array(start_x, particles);
    array(start_d, particles);
    array(touching, particles);
    array(push, particles);
    array(brake, particles);
    array(shift_of_form, n.position_form ? particles : 0);
    array(first, particles);
    array(busy, blocks);
    array(coincide, blocks);
    array.group(groups, n);
    array.later(search, grids, window, cell, shift, diagonal, skin, most_distance, most_stop,
                most_drift, friction, with_excluded, by_groups, waits, age, still, budget, onward,
                early, substep, entry, impulse, capacity);
  }
};

}  // namespace weft
