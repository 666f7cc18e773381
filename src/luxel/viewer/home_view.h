// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "luxel/viewer/background_task.h"
#include "luxel/viewer/camera_controller.h"
#include "luxel/viewer/current_session.h"
#include "luxel/viewer/run_window.h"

namespace luxel {

// The view with which a scene opens: the requested one, or that of the file's first camera, or that of the
// automatic camera, which is found in a thread of its own.
class HomeView {
 public:
  // Prepares for another scene.
  void forget() { has_space_ = is_known_ = false; }
  // Once per frame, while the session has a mesh: sets the camera's space, and its home once it is known.
  void update(const CurrentSession& session, const WindowSettings& settings, CameraController& camera);
  bool is_known() const { return is_known_; }
  bool is_searching() const { return search_.is_busy(); }

 private:
  void begin(const SessionMesh& mesh, const WindowSettings& settings, bool is_first,
             CameraController& camera);

  struct Found {
    std::uint64_t scene;
    Pose pose;
  };
  BackgroundTask<Found> search_;
  bool has_space_ = false, is_known_ = false;
};

}  // namespace luxel
