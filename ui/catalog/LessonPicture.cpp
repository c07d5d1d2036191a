// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/catalog/LessonPicture.h"

#include <algorithm>
#include <utility>

#include <QPainter>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::catalog {
namespace {

using ::lessons::Lesson;
using ::lessons::Task;

constexpr int kLeastHeightPx = 240;
constexpr int kLeastSectionPx = 300;  ///< minimum size of a section, which has a scale and a key
constexpr int kMostHeightPx = 460;
constexpr double kWidthToHeight = 1.05;  ///< width to height of one picture
constexpr double kGapPx = 8.0;

}  // namespace

LessonPicture::LessonPicture(QWidget* parent) : QWidget(parent)
{
    m_pool.setMaxThreadCount(1);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMaximumHeight(kMostHeightPx);
    setObjectName(QStringLiteral("lessonPicture"));
    text::bindTranslation(this, [this] { setAccessibleName(tr("What the lesson asks for, as a picture")); });
}

LessonPicture::~LessonPicture()
{
    m_pool.waitForDone();
}

QSize LessonPicture::sizeHint() const
{
    const QSize least = minimumSizeHint();
    return {2 * least.width(), least.height()};  // grows if there is room
}

QSize LessonPicture::minimumSizeHint() const
{
    const bool mayHaveSection =
        m_lesson && m_lesson->aids.section && (isIdealTold(*m_lesson) || m_lesson->task == Task::RemoveDecay);
    const int high = mayHaveSection ? kLeastSectionPx : kLeastHeightPx;
    return {high, high};
}

void LessonPicture::setLesson(const std::optional<Lesson>& lesson)
{
    if (lesson && m_lesson && lesson->hash == m_lesson->hash)
        return;
    m_lesson = lesson && isPictured(*lesson) ? lesson : std::nullopt;
    m_scene.reset();
    m_cannot = false;
    m_isChanged = m_isAtWork;
    setVisible(m_lesson.has_value());
    updateGeometry();
    startIfWanted();
    update();
}

void LessonPicture::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    startIfWanted();
}

void LessonPicture::startIfWanted()
{
    if (!m_lesson || m_isAtWork || m_scene || m_cannot || !isVisible())
        return;
    m_isAtWork = true;
    // The destructor waits for the pool, so `this` is valid. It also removes queued calls.
    m_pool.start([this, lesson = *m_lesson] {
        const auto scene = makeLessonScene(lesson);
        QMetaObject::invokeMethod(
            this, [this, scene] { take(scene); }, Qt::QueuedConnection);
    });
}

void LessonPicture::take(const std::shared_ptr<const LessonScene>& scene)
{
    m_isAtWork = false;
    if (std::exchange(m_isChanged, false)) {
        startIfWanted();
        return;
    }
    m_scene = scene;
    m_cannot = scene == nullptr;
    update();
}

void LessonPicture::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool hasSection = m_scene && m_scene->plane;
    // The tooth is to the left of the section, if there is a section.
    const double wide = std::min(kWidthToHeight * height(), hasSection ? 0.5 * (width() - kGapPx) : 1.0 * width());
    const QRectF left(0.0, 0.0, wide, height());
    if (!m_scene) {
        painter.fillRect(left, QColor(kPictureGround));
        painter.setPen(QColor(0xFF, 0xFF, 0xFF, 0xB0));
        painter.setFont(kit::typeface(kit::kBody));
        painter.drawText(left, Qt::AlignCenter | Qt::TextWordWrap,
                         m_cannot ? tr("This tooth cannot be created.") : tr("Creating the tooth …"));
        return;
    }
    paintFromAbove(painter, left, *m_scene, hasSection);
    if (!hasSection)
        return;
    inside::paintSection(painter, left.translated(wide + kGapPx, 0.0), sectionOf(*m_scene));
}

}  // namespace ui::catalog
