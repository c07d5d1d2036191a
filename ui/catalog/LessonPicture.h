// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QThreadPool>
#include <QWidget>

#include "lessons/Lesson.h"
#include "ui/catalog/LessonScene.h"

namespace ui::catalog {

/// A preview of a lesson: its tooth from above with its open decay, the outline to cut or the points to touch, and a
/// section if that is an aid of the lesson (see LessonScene). Dark in both themes.
///
/// Another thread builds the tooth when the picture is first visible. If several lessons are chosen quickly, only the
/// last one is built. Ui thread.
class LessonPicture final : public QWidget
{
    Q_OBJECT
public:
    explicit LessonPicture(QWidget* parent);
    ~LessonPicture() override;

    /// Sets the lesson. Hides the widget if there is none or if the lesson has no picture, see isPictured().
    void setLesson(const std::optional<::lessons::Lesson>& lesson);
    /// Returns whether the picture of the current lesson has been built.
    [[nodiscard]] bool isReady() const { return m_scene != nullptr; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void showEvent(QShowEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void startIfWanted();
    void take(const std::shared_ptr<const LessonScene>& scene);

    std::optional<::lessons::Lesson> m_lesson;
    std::shared_ptr<const LessonScene> m_scene;
    bool m_isAtWork = false;
    bool m_isChanged = false;  ///< another lesson was set while the thread was working
    bool m_cannot = false;     ///< its tooth cannot be built; starting the lesson shows the reason
    QThreadPool m_pool;        ///< last: its destructor waits for a job that uses the members above
};

}  // namespace ui::catalog
