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

/// The view of the tooth under the operating light with the bur at its anchor. Converts mouse, pen, touch and keys into
/// the input of the pointer device.
///
/// Mouse: the bur follows the pointer; the left button pushes; dragging with the right or middle button turns the view;
/// the wheel zooms to the point under the pointer. The wheel sets the depth stop while the left button is down or with
/// Shift, and the push force with Ctrl. A double click of the right or middle button, or of the left beside the tooth,
/// resets the view. Keys: arrows move the bur (Shift: finely), page down pushes while held, page up lifts while held,
/// comma and full stop push weaker and harder, Insert and Delete move the depth stop up and down, Ctrl + arrows turn
/// the view, plus and minus zoom, Home resets the view. With Shift, a right drag and Ctrl + arrows turn the tooth about
/// its axis under the handpiece, so that the handpiece turns about the bur.
///
/// Ui thread. The view is the only reader of `servo` and `patches` and the only writer of `pointer`. It polls them 60
/// times a second and repaints only when something visible has changed.
class ToothView : public SceneWidget
{
    Q_OBJECT

public:
    /// @param links  must outlive the view
    explicit ToothView(core::session::UiChannels& links, QWidget* parent = nullptr, Way way = bestWay());
    ~ToothView() override;

    /// Shows the uncut tooth. Applies later patches of `generation` to it; ignores those of an older tooth.
    void setTooth(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy, std::uint64_t generation);
    /// Sets the ideal over the grid of the shown tooth; null: none. A new tooth has none.
    void setIdeal(const core::grading::IdealTop& ideal);
    /// Sets the whole top map of the shown tooth, as it has been cut so far, mm.
    void setHeights(const std::vector<float>& top);
    /// Shows the tooth and the bur of other channels: those of a replay, or the view's own again. The pointer still
    /// controls the view's own channels. Call setTooth() afterwards.
    /// @param channels  must outlive the view
    void showChannels(core::session::UiChannels& channels);
    /// Sets the push force of the button in newtons: 0.2 .. 3, initially 0.6.
    void setPushForce(double newtons);
    /// Sets the largest speed at which the pushed bur is lowered, mm/s.
    void setFeed(double mmPerS);
    /// Sets how the pressure of a pen is converted to force.
    void setPen(const core::settings::PenSettings& settings) { m_pen = settings; }
    /// Switches the depth stop and sets its depth below the original surface, mm.
    void setDepthStop(bool on, double depthMm);
    /// Returns the settings of the pointer: feed, depth stop and force.
    [[nodiscard]] const PointerControl& hand() const { return m_control; }
    /// Returns whether the bur is being pushed, or the left button or the pen's tip is down in the view. The button may
    /// be down without a push, because a view that loses the focus stops pushing.
    [[nodiscard]] bool isPressed() const { return m_isPressed; }
    /// Returns the input device that pressed the bur last.
    [[nodiscard]] PointerKind pushedWith() const { return m_pushedWith; }
    /// Sets the gamepad's input, valid until the next call. After release(), a push must begin again.
    void setPad(const PadInput& pad) { m_pad = pad; }
    /// Stops pushing and turning, whatever is held down.
    void release();
    /// Sets whether the bur is drawn turning.
    void setDrillOn(bool on);
    /// Colours the head of the bur; an invalid colour is that of steel.
    void setBurTint(const QColor& colour);
    /// Sets left-handed use: the handpiece comes from the left and the light from the right. The tooth is not turned:
    /// the lesion of an incisor would be hidden.
    void setLeftHanded(bool leftHanded);
    [[nodiscard]] bool isLeftHanded() const { return m_leftHanded; }
    /// Turns the view by half a circle, to the other side of the patient.
    void turnRound();
    /// Sets the user's choices. The mirror first appears beside the tooth. Dragging its glass moves it, or with Shift
    /// tilts it. The wheel over it moves it nearer or farther. With Alt, the arrow and page keys do the same.
    void setSettings(const ViewSettings& settings);
    [[nodiscard]] const ViewSettings& settings() const { return m_settings; }
    /// Sets the marks of an exercise, or the blindfold. A new tooth has none.
    void setExercise(const ExerciseMarks& marks);
    [[nodiscard]] const ExerciseMarks& exercise() const { return m_exercise; }
    /// Sets the places that comments are pinned to, tooth frame, mm. A new tooth has none.
    void setPins(std::vector<glm::dvec3> placesMm);
    void resetCamera();
    /// Looks from a side with this name (viewpointNames()). Does nothing if the tooth has no such side.
    void lookFrom(const QString& viewpoint);
    /// Sets the viewpoint. For tests.
    void setCamera(double azimuthDeg, double elevationDeg, double distanceMm);
    /// Copies the viewpoint of another camera.
    void lookAs(const Camera& camera);
    /// Stores the viewpoint before another tooth is shown for a while.
    void storeCamera() { m_storedCamera = m_camera; }
    /// Restores the stored viewpoint. Call when the first tooth is back.
    void restoreCamera() { lookAs(m_storedCamera); }
    /// Looks at a place on the tooth from the student's viewpoint. Looks from above if that is unknown, or if the place
    /// is hidden from there.
    /// @param sight  the student's viewpoint; empty: unknown
    void lookAt(const std::optional<core::session::Sight>& sight, glm::dvec3 placeMm);
    /// Returns the current picture, in device pixels.
    [[nodiscard]] QImage picture();
    /// Returns the current picture without the instrument.
    [[nodiscard]] QImage toothPicture();

    /// Returns how the user's head turns the eye; called once per frame.
    /// @param seconds  since the last frame
    /// @param touches  the bur touches the tooth
    using HeadLean = std::function<core::tracking::Lean(double seconds, bool touches)>;
    /// @param lean  empty: no head tracking
    void setHeadLean(HeadLean lean);

    [[nodiscard]] const Camera& camera() const { return m_camera; }
    /// Returns the position of the tip of the bur in this widget. Empty if no bur is shown, or if a stereo picture has
    /// two halves.
    [[nodiscard]] std::optional<QPointF> burAt() const;
    /// Returns the dental mirror; empty while it is hidden.
    [[nodiscard]] const std::optional<render::DentalMirror>& mirror() const { return m_mirror; }
    /// Returns the shown tooth, as cut so far, on its own grid; null before the first. Valid until the next setTooth().
    [[nodiscard]] const core::terrain::Tooth* tooth() const { return m_tooth ? &*m_tooth : nullptr; }
    /// Returns the time of the device pose in the last picture, ns of the steady clock; 0 before the first.
    [[nodiscard]] std::int64_t drawnMomentNs() const { return m_pose.takenNs; }
    /// The data sent to the graphics driver so far.
    struct Uploads
    {
        std::uint64_t bytes = 0;
        std::uint64_t changedBytes = 0;  ///< size of the map rectangles changed by cutting
        int wholes = 0;                  ///< number of times that a whole tooth was sent
    };
    [[nodiscard]] Uploads uploads() const;
    /// Returns a number that grows whenever tooth() changes.
    [[nodiscard]] std::uint64_t toothRevision() const { return m_toothRevision; }

signals:
    /// Emitted once per frame, with the newest state of the servo.
    void frameAdvanced(const core::servo::ServoState& state);
    /// Emitted when feed, depth stop or force of hand() have changed.
    void handChanged();
    /// Emitted when isPressed() has changed.
    void pressedChanged(bool pressed);
    /// Emitted when a push was refused because the tooth is seen from below, where the bur is out of sight.
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
    core::session::UiChannels* m_shown;           ///< source of the shown tooth and bur: m_links, or a replay's
    std::optional<core::terrain::Tooth> m_tooth;  ///< the tooth that m_surface draws, for tooth()
    std::uint64_t m_toothRevision = 0;
    std::unique_ptr<render::ToothSurface> m_surface;
    std::unique_ptr<render::ToothRenderer> m_renderer;
    std::unique_ptr<render::Presenter> m_presenter;
    ViewSettings m_settings;
    ExerciseMarks m_exercise;
    std::vector<glm::dvec3> m_pins;
    std::vector<core::teeth::ArchPiece> m_neighbours;
    bool m_neighboursAreNew = false;  ///< not passed to the renderer yet
    std::optional<render::DentalMirror> m_mirror;
    bool m_mirrorHeld = false;
    bool m_mirrorIsPlaced = false;  ///< placed by the user
    QPointF m_pointer;              ///< the last position of the mouse
    bool m_pointerHasLeft = true;
    bool m_buttonIsDown = false;  ///< the left button, or the tip of the pen
    bool m_penIsMouse = false;    ///< the tip of the pen drags the mirror or was pressed on the gizmo
    bool m_isPressed = false;
    bool m_pointerAims = false;  ///< the bur was last moved by the pointer, not by keys
    PatchInbox m_inbox;
    Camera m_camera;
    Camera m_storedCamera;
    HeadLean m_headLean;
    PointerControl m_control;
    PointerKind m_pushedWith = PointerKind::Mouse;
    TouchGesture m_gesture;
    core::servo::PointerInput m_published;
    core::servo::ServoState m_servo;
    QPixmap m_gizmo;                        ///< the orientation gizmo, as painted last
    std::optional<glm::dmat3> m_gizmoTurn;  ///< the rotation of m_gizmo
    core::servo::Pose m_pose;               ///< the pose in which the bur is drawn
    FrameClock m_clock;

    QElapsedTimer m_sinceTurn;                ///< since the turning bur was last drawn
    QElapsedTimer m_sinceLight;               ///< since all shadows were last updated
    Uploads m_uploads;                        ///< without the bytes
    bool m_surfaceIsNew = false;              ///< not passed to the renderer yet
    render::ToothSurface::Changes m_changes;  ///< since the last picture
    bool m_drillOn = false;
    QColor m_burTint;
    bool m_leftHanded = false;
    bool m_instrumentHidden = false;
    double m_turnRad = 0.0;      ///< rotation of the bur
    double m_handTurnDeg = 0.0;  ///< rotation of the handpiece about the bur, from its natural place
    double m_liftMm = 0.0;       ///< lift of shank and handpiece; follows wantedLiftMm()
    double m_paintedForceN = 0.0;

    Qt::MouseButton m_turning = Qt::NoButton;
    QPointF m_turnedAt;
    std::set<int> m_arrows;  ///< arrow keys that are held
    double m_arrowsHeldS = 0.0;
    bool m_fine = false;
    core::settings::PenSettings m_pen;
    PadInput m_pad;
    bool m_padIsDown = false;  ///< the gamepad's trigger was pressed in the last frame
    bool m_padPushes = false;  ///< the current push comes from the gamepad
    QTimer m_frame;
    QElapsedTimer m_sinceFrame;
    // Time since a value was last changed; the value is shown beside the bur for a moment.
    QElapsedTimer m_sinceForceSet;
    QElapsedTimer m_sinceStopSet;
};

}  // namespace ui::tooth
