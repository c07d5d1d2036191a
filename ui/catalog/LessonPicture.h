// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include <QThreadPool>
#include <QWidget>

#include "lessons/Lesson.h"
#include "ui/catalog/LessonScene.h"

namespace ui::catalog {

/// What a lesson asks for, before it is begun: its tooth from above with its open decay, the outline that is to be cut
/// or the points that are to be touched, and a section where that is an aid of the lesson (see LessonScene). Dark in
/// either theme, like the room with the tooth.
///
/// The tooth is made on another thread, when the picture is first seen; of lessons that are chosen quickly one after
/// the other only the last. Ui thread.
class LessonPicture final : public QWidget
{
    Q_OBJECT
public:
    explicit LessonPicture(QWidget* parent);
    ~LessonPicture() override;

    /// Nothing: the widget is hidden, as for what is felt and not seen.
    void setLesson(const std::optional<::lessons::Lesson>& lesson);
    /// The picture is that of the lesson said last.
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
    bool m_isChanged = false;  ///< another lesson was said meanwhile
    bool m_cannot = false;     ///< its tooth cannot be made; starting the lesson says why
    QThreadPool m_pool;        ///< last: waited for before what it answers to goes away
};

}  // namespace ui::catalog
