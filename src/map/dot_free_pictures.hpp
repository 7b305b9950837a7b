// Pictures of a depth camera in which the dots of its projector do not show.
#pragma once

#include <string_view>

#include "camera/camera.hpp"
#include "depth/image.hpp"
#include "infrared/reference_surface.hpp"
#include "map/joint_turn.hpp"

namespace rva {

/// Takes pictures by the left infrared imager under the lamp, where the camera has one, and otherwise by the
/// colour imager, which does not see the projector's infrared light.
class DotFreePictures {
 public:
  /// @param camera must outlive this object
  /// @throws Error when it has neither a lamp nor a colour imager whose position is known
  explicit DotFreePictures(Camera& camera);
  ~DotFreePictures();  ///< switches the projector on
  DotFreePictures(const DotFreePictures&) = delete;
  DotFreePictures& operator=(const DotFreePictures&) = delete;

  /// Which imager takes the pictures, under which light, for the user.
  [[nodiscard]] std::string_view name() const;
  /// The imager that takes the pictures.
  [[nodiscard]] const PictureImager& imager() const { return imager_; }

  /// Drops the frames that were exposed while the camera came to rest.
  void settle();

  /// The mean of several frames: the root of their light, or nearly so, in which noise is even.
  /// @throws Error when the camera fails, or gives no images of the imager; Interrupted
  [[nodiscard]] Image<float> take(int frames);

  /// What the depth imager sees, in the mean of several frames.
  /// @throws Error as take(), and when no depth is measured
  [[nodiscard]] ReferenceSurface surface(int frames);

 private:
  [[nodiscard]] CameraFrame next_frame();

  Camera& camera_;
  Light light_;
  PictureImager imager_;
};

}  // namespace rva
