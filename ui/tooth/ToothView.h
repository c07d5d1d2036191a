// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QColor>
#include <QElapsedTimer>
#include <QImage>
#include <QPixmap>
#include <QPointF>
#include <QTimer>

#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/settings/PenSettings.h"
#include "core/teeth/Arch.h"
#include "core/terrain/Tooth.h"
#include "ui/render/ToothRenderer.h"
#include "ui/render/ToothSurface.h"
#include "ui/tooth/Camera.h"
#include "ui/tooth/ExerciseMarks.h"
#include "ui/tooth/PadInput.h"
#include "ui/tooth/PatchInbox.h"
#include "ui/tooth/PointerControl.h"
#include "ui/tooth/PointerKind.h"
#include "ui/tooth/PoseTrack.h"
#include "ui/tooth/SceneWidget.h"
#include "ui/tooth/TouchGesture.h"
#include "ui/tooth/ViewSettings.h"

namespace ui::tooth {

/// The tooth under the operating light, the bur at its anchor, and the hand: mouse, pen and keys become what the
/// pointer device asks for.
///
/// Mouse: the bur follows; left button pushes; right or middle drag turns the view, wheel zooms to what is under the
/// pointer. The wheel sets the depth stop while the left button is down or with Shift, and how hard to push with Ctrl.
/// A double click of the right or middle button, or of the left beside the tooth, resets the view. Keys: arrows move
/// the bur (Shift: finely), page down pushes while held, page up lifts while held, comma and full stop push weaker and
/// harder, Insert and Delete move the depth stop up and down, Ctrl + arrows turn the view, plus and minus zoom, Home
/// resets the view. With Shift, a right drag and Ctrl + arrows turn the tooth about its axis under the handpiece: that
/// swings round the bur.
///
/// Ui thread. It is the one reader of `servo` and `patches` and the one writer of `pointer`; it polls them 60 times a
/// second and repaints only when something that shows has changed.
class ToothView : public SceneWidget
{
    Q_OBJECT

public:
    /// @param links  must outlive the view
    explicit ToothView(core::session::UiChannels& links, QWidget* parent = nullptr, Way way = bestWay());
    ~ToothView() override;

    /// Shows the uncut tooth; patches of `generation` are then applied to it, those of an older one ignored.
    void setTooth(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::uint64_t generation);
    /// What the lesson asks for, over the grid of the tooth that is shown; null: nothing. A new tooth has none.
    void setIdeal(const core::grading::IdealTop& ideal);
    /// The tooth shown as it has been cut so far: its whole top map.
    void setHeights(const std::vector<float>& top);
    /// Shows the tooth and the bur of other channels: those of a replay, or its own again. The pointer goes on to
    /// control the own ones. setTooth() follows.
    /// @param channels  must outlive the view
    void showChannels(core::session::UiChannels& channels);
    /// How hard the button pushes, newtons: 0.2 .. 3, 0.6 to begin with.
    void setPushForce(double newtons);
    /// Sets the largest speed at which the pushed bur goes down, mm/s.
    void setFeed(double mmPerS);
    /// Sets how the pressure of a pen becomes force.
    void setPen(const core::settings::PenSettings& settings) { m_pen = settings; }
    /// Switches the depth stop and sets its depth below the original surface, mm.
    void setDepthStop(bool on, double depthMm);
    /// Returns the settings of the hand: feed, depth stop and force.
    [[nodiscard]] const PointerControl& hand() const { return m_control; }
    /// True while the bur is pushed or the left button, or the tip of the pen, is down in the view. The button may be
    /// down without a push: a view that loses the focus stops pushing.
    [[nodiscard]] bool isPressed() const { return m_isPressed; }
    /// Returns the input device that pressed the bur last.
    [[nodiscard]] PointerKind pushedWith() const { return m_pushedWith; }
    /// Sets what a gamepad asks for, until the next call. A push begins anew after release().
    void setPad(const PadInput& pad) { m_pad = pad; }
    /// Nothing is pushed or turned any more, whatever is held down.
    void release();
    /// For the look of the bur only.
    void setDrillOn(bool on);
    /// Colours the head of the bur; an invalid colour is that of steel.
    void setBurTint(const QColor& colour);
    /// The other hand: the handpiece comes from the left and the light from the right. The tooth stays as it is seen:
    /// turned round, an incisor would hide its lesion.
    void setLeftHanded(bool leftHanded);
    [[nodiscard]] bool isLeftHanded() const { return m_leftHanded; }
    /// Half a circle, as it is for who sits on the other side of the patient.
    void turnRound();
    /// The mirror is put beside the tooth when it is shown; then it is moved by dragging its glass, tilted so with
    /// Shift, and moved to and fro with the wheel over it; with Alt, arrows and page keys do the same.
    void setSettings(const ViewSettings& settings);
    [[nodiscard]] const ViewSettings& settings() const { return m_settings; }
    /// What an exercise marks on the tooth, or that the view is blindfolded; a new tooth has nothing of it.
    void setExercise(const ExerciseMarks& marks);
    [[nodiscard]] const ExerciseMarks& exercise() const { return m_exercise; }
    /// Places that somebody remarked something of, mm, in the tooth's frame; a new tooth has none.
    void setPins(std::vector<glm::dvec3> placesMm);
    void resetCamera();
    /// Looks from a side with this name (viewpointNames()). Does nothing if the tooth has no such side.
    void lookFrom(const QString& viewpoint);
    /// For tests, which look from where they must.
    void setCamera(double azimuthDeg, double elevationDeg, double distanceMm);
    /// From where another view looks.
    void lookAs(const Camera& camera);
    /// Stores from where the view looks, before another tooth is shown for a while.
    void storeCamera() { m_storedCamera = m_camera; }
    /// Looks from there again. Call it when the first tooth is back.
    void restoreCamera() { lookAs(m_storedCamera); }
    /// Looks at a place on the tooth as the student did. Looks from above if it is not known from where they looked, or
    /// if the place is hidden from there.
    /// @param sight  from where the student looked; empty if it is not known
    void lookAt(const std::optional<core::session::Sight>& sight, glm::dvec3 placeMm);
    /// What is shown now, in device pixels.
    [[nodiscard]] QImage picture();
    /// The same without the instrument: what has become of the tooth.
    [[nodiscard]] QImage toothPicture();

    /// Asked in every frame how the eye leans. Empty: it does not.
    /// @param seconds  since the frame before
    /// @param touches  the bur touches the tooth
    using HeadLean = std::function<core::tracking::Lean(double seconds, bool touches)>;
    void setHeadLean(HeadLean lean);

    [[nodiscard]] const Camera& camera() const { return m_camera; }
    /// Returns where the tip of the bur is seen in this widget. Empty if no bur is shown, or if the picture has two
    /// halves.
    [[nodiscard]] std::optional<QPointF> burAt() const;
    /// The dental mirror where it is held; nothing while it is put away.
    [[nodiscard]] const std::optional<render::DentalMirror>& mirror() const { return m_mirror; }
    /// The tooth that is shown, as cut so far, at its own grid; null before the first. Valid until the next setTooth().
    [[nodiscard]] const core::terrain::Tooth* tooth() const { return m_tooth ? &*m_tooth : nullptr; }
    /// When the device was where the last picture shows it: steady clock, ns; 0 before the first.
    [[nodiscard]] std::int64_t drawnMomentNs() const { return m_pose.takenNs; }
    /// What went to the graphics driver so far.
    struct Uploads
    {
        std::uint64_t bytes = 0;
        std::uint64_t changedBytes = 0;  ///< of the rectangles of the maps that were changed by cutting
        int wholes = 0;                  ///< times that all of a tooth went
    };
    [[nodiscard]] Uploads uploads() const;
    /// Grows whenever tooth() changes.
    [[nodiscard]] std::uint64_t toothRevision() const { return m_toothRevision; }

signals:
    /// Once a frame, with the newest state of the servo.
    void frameAdvanced(const core::servo::ServoState& state);
    /// Emitted when feed, depth stop or force of hand() have changed.
    void handChanged();
    /// Emitted when isPressed() has changed.
    void pressedChanged(bool pressed);
    /// The bur was to push while the tooth is seen from below: it did not, as it would drill where nobody looks.
    void pushRefused();

protected:
    bool event(QEvent* event) override;
    [[nodiscard]] bool prepareScene(QString& reason) override;
    void releaseScene() override;
    void drawScene(QSize sizePx, int samples) override;
    void paintMarks(QPainter& painter) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void advanceFrame();
    void followHead(double seconds);
    void takePatches();
    void takeChanges(const render::ToothSurface::Changes& changes);
    void takeAllChanges();
    void moveByKeys(double seconds);
    void moveByPad(double seconds);
    void stepByKey(int key, double lengthMm);
    void pressArrow(const QKeyEvent& event);
    void moveMirrorByKey(int key);
    void push(PointerKind kind);
    void pushAt(QPointF position, PointerKind kind);
    void touch(const QTouchEvent& event);
    void publishPointer();
    void setButtonDown(bool down);
    void updatePressed();
    void turnCamera(double azimuthDeg, double elevationDeg);
    void turnHandpiece(double degrees);
    void showNeighbours();
    void drawForce(QPainter& painter);
    void drawStop(QPainter& painter);
    void moveStop(double stepMm);
    void aim();
    void drawGizmo(QPainter& painter);
    [[nodiscard]] std::optional<std::size_t> gizmoEndAt(QPointF position) const;
    void drawPoints(QPainter& painter);
    void drawPins(QPainter& painter);
    void drawPads(QPainter& painter);
    [[nodiscard]] bool isOnMirror(QPointF position) const;
    void dragMirror(QPointF by, bool tilts);
    void pushMirror(double millimetres);
    void placeMirror();
    void pointAt(QPointF position);
    [[nodiscard]] QPointF presented(QPointF position) const;
    [[nodiscard]] QPointF presentedWay(QPointF by) const;
    [[nodiscard]] render::Ray rayAt(QPointF position) const;
    [[nodiscard]] render::Scene scene(QSizeF sizePx) const;
    [[nodiscard]] bool showsInstrument() const;

    core::session::UiChannels& m_links;
    core::session::UiChannels* m_shown;  ///< whose tooth and bur are seen: m_links, or those of a replay
    std::optional<core::terrain::Tooth> m_tooth;  ///< what m_surface draws, for those who look inside
    std::uint64_t m_toothRevision = 0;
    std::unique_ptr<render::ToothSurface> m_surface;
    std::unique_ptr<render::ToothRenderer> m_renderer;
    std::unique_ptr<render::Presenter> m_presenter;
    ViewSettings m_settings;
    ExerciseMarks m_exercise;
    std::vector<glm::dvec3> m_pins;
    std::vector<core::teeth::ArchPiece> m_neighbours;
    bool m_neighboursAreNew = false;  ///< the renderer has not seen them
    std::optional<render::DentalMirror> m_mirror;
    bool m_mirrorHeld = false;
    bool m_mirrorIsPlaced = false;  ///< by a person
    QPointF m_pointer;              ///< where the mouse was last
    bool m_pointerHasLeft = true;
    bool m_buttonIsDown = false;  ///< the left one, or the tip of the pen
    bool m_penIsMouse = false;    ///< the tip of the pen holds the mirror or was put on the letters of the sides
    bool m_isPressed = false;
    bool m_pointerAims = false;  ///< the bur was last moved with the pointer, not with keys
    PatchInbox m_inbox;
    Camera m_camera;
    Camera m_storedCamera;
    HeadLean m_headLean;
    PointerControl m_control;
    PointerKind m_pushedWith = PointerKind::Mouse;
    TouchGesture m_gesture;
    core::servo::PointerInput m_published;
    core::servo::ServoState m_servo;
    QPixmap m_gizmo;                        ///< as it was painted last,
    std::optional<glm::dmat3> m_gizmoTurn;  ///< turned so
    core::servo::Pose m_pose;               ///< of the bur as it is drawn
    FrameClock m_clock;

    QElapsedTimer m_sinceTurn;                ///< of the bur was shown
    QElapsedTimer m_sinceLight;               ///< was brought up to date everywhere
    Uploads m_uploads;                        ///< without their bytes
    bool m_surfaceIsNew = false;              ///< the renderer has not seen it
    render::ToothSurface::Changes m_changes;  ///< since the last picture
    bool m_drillOn = false;
    QColor m_burTint;
    bool m_leftHanded = false;
    bool m_instrumentHidden = false;
    double m_turnRad = 0.0;      ///< of the bur
    double m_handTurnDeg = 0.0;  ///< of the handpiece about the bur, from where the hand holds it by nature
    double m_liftMm = 0.0;       ///< of shank and handpiece, follows wantedLiftMm()
    double m_paintedForceN = 0.0;

    Qt::MouseButton m_turning = Qt::NoButton;
    QPointF m_turnedAt;
    std::set<int> m_arrows;  ///< held
    double m_arrowsHeldS = 0.0;
    bool m_fine = false;
    core::settings::PenSettings m_pen;
    PadInput m_pad;
    bool m_padIsDown = false;  ///< its trigger pushed in the last frame
    bool m_padPushes = false;  ///< the push that goes on is the gamepad's
    QTimer m_frame;
    QElapsedTimer m_sinceFrame;
    // Each is valid for a moment, while the value is written beside the bur.
    QElapsedTimer m_sinceForceSet;
    QElapsedTimer m_sinceStopSet;
};

}  // namespace ui::tooth
