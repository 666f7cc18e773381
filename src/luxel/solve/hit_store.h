// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/core/work_partition.h"
#include "luxel/lamps/portals.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/sample_state.h"
#include "luxel/trace/escape_tints.h"
#include "luxel/trace/gather_rays.h"
#include "luxel/trace/gather_sides.h"
#include "luxel/trace/panes.h"
#include "luxel/trace/tracer.h"

namespace luxel {

struct HitStoreOptions {
  std::uint64_t seed = 1;
  std::uint32_t replicates = 8;
  bool low_discrepancy = true;  // else independent random numbers
  bool stratified = true;       // one sequence over neighbouring patches; else each side has its own
};

// First hits of the cosine rays that gather light: in each replicate n Owen-scrambled rays per side. Rays are
// added in rounds, to all sides or to some; earlier ones stay. Hits are stored, or streamed: traced again
// whenever they are read, which needs no memory and gives the same bits.
//
// Elements are the receivers of GatherSides. Rays that bring no light end in sinks, elements of their own
// after the receivers, whose radiosity is 0 or the sky's: escaped (one for each patch of the sky), dark (a
// side that does not gather), and one for each one-sided material's back; where there are portals also some
// for rays that escape through a portal, again one for each patch of the sky: their light is direct light.
//
// Panes of glass: hits have no weights, so a ray is kept with the probability of the luminous transmittance
// of the panes it crosses, by a hash of the ray, and else ends in the sink of the panes. Escapes through
// tinted panes end in sinks of their own, one for each tint (EscapeTints); rays to surfaces carry all bands
// alike.
//
// Memory: 4 bytes per stored ray. Cost of a round: one nearest hit per ray. Not safe to change while another
// call runs; any number of threads may read.
class HitStore {
 public:
  // Keeps references to patches and tracer. work: processes share the rows, each traces and stores the hits
  // of its own.
  HitStore(const PatchSet& patches, GatherSides sides, const Tracer& tracer, const HitStoreOptions& options,
           const SharedWork& work = {});

  const GatherSides& sides() const { return sides_; }
  std::uint32_t replicates() const { return options_.replicates; }
  // Rays of each receiver, of one replicate.
  std::span<const std::uint32_t> rays_per_receiver() const { return rays_per_receiver_; }

  // Doubles the rays of these receivers (rising; all with equally many so far); receivers without rays get
  // `first`, a power of two. Returns the rays traced, or none, with nothing added, if the monitor stops the
  // work.
  std::optional<std::uint64_t> double_rays(std::vector<std::uint32_t> receivers, std::uint32_t first,
                                           const Context& context = {});

  // Moves rows, with their hits, between the processes so that all finish more rays at the same time, by the
  // measured time of earlier rays. more_rays: [receiver], of one replicate; other_seconds: of a thread, for
  // work that is divided by what this returns. Before there were rays all are ready at once. All processes
  // call this together.
  ProcessTimes balance(std::span<const double> more_rays, double other_seconds);

  // Traces the rays of all rounds again, through the panes of glass as they are now, and stores the hits.
  // Alone, not with other processes.
  void trace_again(const Context& context);

  // Discards the hits, and those of later rounds: they are streamed from now on.
  void stream();
  bool is_streamed() const { return is_streamed_; }
  std::uint64_t bytes() const;  // of the hits

  // Leaves out the receivers that are not kept: rays to them end in the dark.
  void keep(const std::vector<std::uint8_t>& kept, const Context& context);

  // All rounds so far; copies share the hits. With several processes the first has all hits, the others none.
  std::vector<HitRound> rounds() const;
  const RowPartition& partition() const { return partition_; }
  // Goes on where an operator over the same receivers was, whose rounds these are. Throws MismatchError where
  // they cannot be: receivers and elements in range and rising, each receiver's rounds one after the other.
  void restore(std::vector<HitRound> rounds);

  // Sinks, from size() on. Those of the sky's first patch have the numbers that a sky of one patch has.
  std::size_t escaped(std::size_t sky_patch = 0) const {
    return sky_patch == 0 ? sides_.size() : first_extra() + sky_patch - 1;
  }
  std::size_t dark() const { return sides_.size() + 1; }
  std::size_t absorbed(std::size_t material) const { return sides_.size() + 2 + material; }
  // Sink of escapes through a portal; no element if there is no portal.
  std::size_t through_portal(std::size_t sky_patch = 0) const {
    return sky_patch == 0 ? absorbed(patches_.materials.size())
                          : first_extra() + (sky_patches() - 1) + sky_patch - 1;
  }
  bool has_portals() const { return !portals_.empty(); }
  std::size_t sky_patches() const { return patches_.sky_patches.size(); }
  // Sink of absorption by a pane of glass; no element if there is no pane.
  std::size_t in_panes() const { return first_extra() + (has_portals() ? 2 : 1) * (sky_patches() - 1); }
  bool has_panes() const { return !panes_.empty(); }
  // Sink of escapes through tinted panes; no element if none is tinted.
  std::size_t tinted(std::size_t sky_patch, std::size_t tint) const {
    return in_panes() + 1 + sky_patch * tints_.size() + tint;
  }
  std::size_t tinted_through_portal(std::size_t sky_patch, std::size_t tint) const {
    return tinted(sky_patches() + sky_patch, tint);
  }
  std::size_t tints() const { return tints_.size(); }
  // An escape not through a portal; any.
  bool is_sky(std::size_t element) const {
    return element == escaped() ||
           (element >= first_extra() && element < first_extra() + sky_patches() - 1) ||
           (element >= tinted(0, 0) && element < tinted(sky_patches(), 0));
  }
  bool is_escape(std::size_t element) const {
    return element == escaped() || (has_portals() && element == through_portal()) ||
           (element >= first_extra() && element != in_panes());
  }
  // The sky patch of an escape.
  std::size_t sky_patch_of(std::size_t element) const {
    if (element < first_extra()) return 0;
    if (element >= tinted(0, 0)) return (element - tinted(0, 0)) / tints() % sky_patches();
    const auto extra = element - first_extra(), further = sky_patches() - 1;
    return 1 + (extra < further ? extra : extra - further);
  }
  // Factor of a band in the light that such rays carry.
  double tint_of(std::size_t element, std::size_t band) const {
    return element < tinted(0, 0) ? 1.0 : tints_.of((element - tinted(0, 0)) % tints(), band);
  }
  std::size_t elements() const {
    return has_panes() ? tinted((has_portals() ? 2 : 1) * sky_patches(), 0) : in_panes();
  }

  std::size_t blocks() const { return block_begins_.size() - 1; }
  // Block k is the receivers [block_begins()[k], block_begins()[k + 1]).
  std::span<const std::uint32_t> block_begins() const { return block_begins_; }
  bool is_mine(std::uint32_t receiver) const { return partition_.is_mine(sides_.position[receiver]); }
  // Calls body(receiver, element hit) for every ray of one replicate whose receiver lies in that block; of
  // several processes, for this one's blocks alone.
  template <typename Body>
  void for_each_hit(std::uint32_t replicate, std::size_t block, Body body) const {
    for_each_round(
        replicate, block,
        [&](std::span<const std::uint32_t> receivers, const std::uint32_t* hit, std::uint32_t per_replicate) {
          for (const auto receiver : receivers)
            for (std::uint32_t i = 0; i < per_replicate; ++i) body(receiver, *hit++);
        });
  }

  // Does the same for the rays of the first round only, the first of every receiver.
  template <typename Body>
  void for_each_first_hit(std::uint32_t replicate, std::size_t block, Body body) const {
    for_each_round(replicate, block, std::span(rounds_).first(std::min<std::size_t>(1, rounds_.size())),
                   [&](std::span<const std::uint32_t> receivers, const std::uint32_t* hit, std::uint32_t n) {
                     for (const auto receiver : receivers)
                       for (std::uint32_t i = 0; i < n; ++i) body(receiver, *hit++);
                   });
  }

  // Calls body(receivers, their hits, hits per receiver) for each round that has receivers in that block.
  template <typename Body>
  void for_each_round(std::uint32_t replicate, std::size_t block, Body body) const {
    for_each_round(replicate, block, rounds_, body);
  }
  // Gathers the numbers of each process's own receivers, `width` per receiver, in all processes.
  void all_gather_receivers(std::span<float> values, std::size_t width) const;

  // Blocks whose rays are traced together where all receivers get per_replicate rays: where they begin,
  // receivers, and at the end size().
  std::vector<std::uint32_t> traced_together(std::uint32_t per_replicate) const;

 private:
  struct Round : HitRound {
    std::vector<std::uint32_t> begins;  // [block + 1], into receivers

    std::span<const std::uint32_t> receivers_of(std::size_t block) const {
      return std::span(receivers).subspan(begins[block], begins[block + 1] - begins[block]);
    }
    std::uint32_t* hits_of(std::uint32_t replicate, std::size_t place) const {
      return hits.get() + replicate * hits_per_replicate() + place * per_replicate;
    }
  };

  template <typename Body>
  void for_each_round(std::uint32_t replicate, std::size_t block, std::span<const Round> rounds,
                      Body body) const {
    std::vector<std::uint32_t> traced;
    for (const auto& round : rounds) {
      const auto receivers = round.receivers_of(block);
      if (receivers.empty()) continue;
      const std::size_t n = round.per_replicate;
      if (is_streamed_) {
        traced.resize(receivers.size() * n);
        std::vector<std::uint32_t*> to(options_.replicates);
        to[replicate] = traced.data();
        trace(round, receivers, replicate * n, (replicate + 1) * n, to);
      }
      body(receivers, is_streamed_ ? traced.data() : round.hits_of(replicate, round.begins[block]),
           round.per_replicate);
    }
  }

  Round make_round(HitRound round) const;
  // Does not zero the memory: a thread that writes a page also gets it.
  void make_room(Round& round) const;
  // Counts the rays of a round with these receivers.
  void count(std::span<const std::uint32_t> receivers, std::uint32_t per_replicate);
  std::vector<std::uint32_t> mine(std::vector<std::uint32_t> receivers) const;
  HitRound gathered(const HitRound& own) const;
  Round own_part(const Round& whole) const;
  void move_rows(std::vector<std::uint32_t> owners);
  // Updates the pace by an own round and the seconds of each job. groups: places of receivers, [group + 1].
  void learn_pace(const Round& own, std::span<const std::uint32_t> groups,
                  std::span<const double> job_seconds, double seconds);
  // The elements that rows of these receivers' rays hit. Row = replicate * per_replicate + sample;
  // to[replicate]: where the samples of the first receiver go.
  void trace(const Round& round, std::span<const std::uint32_t> receivers, std::size_t begin_row,
             std::size_t end_row, std::span<std::uint32_t* const> to) const;
  std::uint32_t element_of(const Hit& hit, const Ray& ray) const;
  std::uint32_t escape_of(const Ray& ray, std::optional<std::size_t> tint) const;
  // The sinks of the sky's further patches begin here.
  std::size_t first_extra() const { return absorbed(patches_.materials.size()) + (has_portals() ? 1 : 0); }

  const PatchSet& patches_;
  const Tracer& tracer_;
  Portals portals_;
  Panes panes_;
  EscapeTints tints_;
  GatherSides sides_;
  HitStoreOptions options_;
  RowPartition partition_;
  // Times of this process since it was balanced: seconds of its threads together, and of the clock.
  double busy_seconds_ = 0.0, traced_seconds_ = 0.0;
  std::vector<double>
      seconds_per_receiver_;  // [block of partition_]: for one ray per replicate, as its owner measured
  std::vector<std::uint32_t> block_begins_;
  std::vector<Round> rounds_;
  std::vector<std::uint32_t> rays_per_receiver_, doublings_;
  bool is_streamed_ = false;
};

}  // namespace luxel
