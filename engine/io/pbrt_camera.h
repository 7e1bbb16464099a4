// pbrt's cameras, films, filters and integrators as Glint's camera and options. Internal to the
// pbrt importer.
#pragma once

#include "engine/io/pbrt_state.h"

namespace glint {

/// What stands before WorldBegin. Each of the directives may come first.
class PbrtView {
  public:
    explicit PbrtView(PbrtContext* context) : context_(*context) {}

    /// `state`: its transform leads from the world to the camera.
    void setCamera(const std::string& kind, PbrtParams params, const PbrtState& state);
    void setFilm(const std::string& kind, PbrtParams params);
    void setFilter(const std::string& kind, const PbrtParams& params);
    void setIntegrator(const std::string& kind, const PbrtParams& params);

    bool hasCamera() const { return hasCamera_; }
    /// Sets the camera, the picture's size, and how the scene is placed (PbrtContext::world): pbrt's cameras
    /// are left-handed, so that a scene is mirrored unless the file mirrors it.
    void finish();
    /// What the film makes of the scene's light: a factor, and its white balance.
    float exposure() const { return exposure_; }
    const Mat3& balance() const { return balance_; }

  private:
    /// The rectangle of pbrt's screen that the picture shows.
    struct Screen {
        Vec2 middle{0.0f}, half{1.0f};
    };
    /// The pixels of the film's picture that are there.
    struct Window {
        Resolution whole{1280, 720};
        Vec2i low{0}, high{1280, 720};
    };

    Window readFilm();
    void readSensor();
    Window readWindow(const Resolution& whole);
    Screen readScreen(const Window& window);
    void placeCamera(const Screen& screen);
    /// Sets the kind, the angle and the lens; gives back what a length of the screen is at distance 1, or of
    /// parallel rays anywhere.
    float readLens(const Screen& screen, float unit);
    void lookAsWritten();

    PbrtContext& context_;
    bool hasCamera_ = false, hasFilm_ = false;
    std::string cameraKind_;
    PbrtParams camera_, film_;
    glm::dmat4 cameraFromWorld_{1.0};
    std::vector<double> look_;
    float exposure_ = 1.0f;
    Mat3 balance_{1.0f};
};

/// Multiplies all that shines, and balances its colours; of images that shine, by what white becomes.
void scaleLight(float exposure, const Mat3& balance, SceneDescription* scene);

}  // namespace glint
