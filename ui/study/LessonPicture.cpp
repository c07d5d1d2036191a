// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/LessonPicture.h"

#include <algorithm>
#include <numbers>
#include <utility>
#include <variant>

#include <QPainter>

#include "core/preparation/ToleranceBand.h"
#include "lessons/Assignment.h"
#include "lessons/Capture.h"
#include "ui/inside/OutlinePainter.h"
#include "ui/inside/SectionPainter.h"
#include "ui/shell/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::study {
namespace {

using ::lessons::Lesson;
using ::lessons::Task;

constexpr int kLeastHeightPx = 240;
constexpr int kLeastSectionPx = 300;  ///< of a section in particular, which has a scale and a key
constexpr int kMostHeightPx = 460;
constexpr double kWidthToHeight = 1.05;  ///< of one picture
constexpr double kGapPx = 8.0;
constexpr QRgb kGround = 0xFF15181A;
constexpr QRgb kRing = 0xFF56C7C9;

bool isSeen(const Lesson& lesson)
{
    return lesson.task != Task::TellLayers;
}

/// Whoever is to look for decay is not told where it ends.
bool isIdealTold(const Lesson& lesson)
{
    return lesson.aids.ideal && (lesson.task == Task::CutIdeal || lesson.task == Task::TraceShape);
}

}  // namespace

struct LessonPicture::Scene
{
    ::lessons::Assignment assignment;
    core::terrain::Tooth whole;
    inside::FromAbove above;
    core::grading::IdealTop ideal;  ///< null: not told
    double outlineMm = 0.0;         ///< tolerance
    std::optional<core::preparation::ToleranceBand> band;
    core::imaging::SectionPlane plane;
};

LessonPicture::LessonPicture(QWidget* parent) : QWidget(parent)
{
    m_pool.setMaxThreadCount(1);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMaximumHeight(kMostHeightPx);
    setObjectName(QStringLiteral("lessonPicture"));
    text::inEveryLanguage(this, [this] { setAccessibleName(tr("What the lesson asks for, as a picture")); });
}

LessonPicture::~LessonPicture()
{
    m_pool.waitForDone();
}

QSize LessonPicture::sizeHint() const
{
    const QSize least = minimumSizeHint();
    return {2 * least.width(), least.height()};  // and more where there is room
}

QSize LessonPicture::minimumSizeHint() const
{
    const int high = m_lesson && isIdealTold(*m_lesson) ? kLeastSectionPx : kLeastHeightPx;
    return {high, high};
}

void LessonPicture::setLesson(const std::optional<Lesson>& lesson)
{
    if (lesson && m_lesson && lesson->hash == m_lesson->hash)
        return;
    m_lesson = lesson && isSeen(*lesson) ? lesson : std::nullopt;
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

std::shared_ptr<const LessonPicture::Scene> LessonPicture::sceneOf(const Lesson& lesson)
{
    auto assigned = ::lessons::assign(lesson);
    if (!assigned)
        return nullptr;
    ::lessons::Assignment& assignment = assigned->assignment;
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    const core::grading::IdealTop ideal = isIdealTold(lesson) ? assignment.shownIdeal() : nullptr;
    auto scene = std::make_shared<Scene>(Scene{assignment,
                                               core::terrain::Tooth(assignment.anatomy),
                                               inside::fromAbove(anatomy, ideal ? *ideal : anatomy.top),
                                               ideal,
                                               0.0,
                                               std::nullopt,
                                               {}});
    if (!ideal)
        return scene;
    core::preparation::Tolerances tolerances{0.0, 0.0, 0.0, 0.0};
    if (assignment.leeway)
        tolerances = {assignment.leeway->sidesMm, assignment.leeway->bottomMm, 0.0, 0.0};
    tolerances = ::lessons::tolerancesOf(lesson.rubric, tolerances);
    scene->outlineMm = tolerances.outlineMm;
    scene->band =
        core::preparation::toleranceBand(anatomy, *assignment.ideal, tolerances.outlineMm, tolerances.depthMm);
    scene->plane.throughMm = assignment.ideal->isthmus ? assignment.ideal->isthmus->atMm : anatomy.grid.middleMm();
    scene->plane.angleRad = 0.5 * std::numbers::pi;
    return scene;
}

void LessonPicture::startIfWanted()
{
    if (!m_lesson || m_isAtWork || m_scene || m_cannot || !isVisible())
        return;
    m_isAtWork = true;
    // The destructor waits for the pool, and takes with it what was still to come here.
    m_pool.start([this, lesson = *m_lesson] {
        const auto scene = sceneOf(lesson);
        QMetaObject::invokeMethod(
            this, [this, scene] { take(scene); }, Qt::QueuedConnection);
    });
}

void LessonPicture::take(const std::shared_ptr<const Scene>& scene)
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
    const bool hasSection = m_scene && m_scene->ideal && m_lesson && m_lesson->aids.section;
    const double wide = std::min(kWidthToHeight * height(), 0.5 * (width() - kGapPx));
    const QRectF left(0.0, 0.0, wide, height());
    if (!m_scene) {
        painter.fillRect(left, QColor(kGround));
        painter.setPen(QColor(0xFF, 0xFF, 0xFF, 0xB0));
        painter.setFont(shell::typeface(shell::kBody));
        painter.drawText(left, Qt::AlignCenter | Qt::TextWordWrap,
                         m_cannot ? tr("This tooth cannot be made.") : tr("The tooth is being made …"));
        return;
    }
    const auto& assignment = m_scene->assignment;
    inside::paintOutline(painter, left,
                         {assignment.anatomy.get(), &m_scene->above, m_scene->outlineMm, 0.0,
                          hasSection ? std::optional(m_scene->plane) : std::nullopt});
    if (assignment.exercise)
        if (const auto* asked = std::get_if<core::grading::PointsToTouch>(&*assignment.exercise)) {
            painter.setPen(QPen(QColor(kRing), 2.0));
            painter.setBrush(Qt::NoBrush);
            for (const glm::dvec2& point : asked->pointsMm) {
                const QPointF middle = inside::placeOf(left, m_scene->above, {point.x, point.y});
                const QPointF edge = inside::placeOf(left, m_scene->above, {point.x + asked->reachMm, point.y});
                painter.drawEllipse(middle, edge.x() - middle.x(), edge.x() - middle.x());
            }
        }
    if (!hasSection)
        return;
    inside::SectionScene section;
    section.tooth = &m_scene->whole;
    section.plane = m_scene->plane;
    section.ideal = m_scene->ideal;
    section.band = m_scene->band ? &*m_scene->band : nullptr;
    inside::paintSection(painter, left.translated(wide + kGapPx, 0.0), section);
}

}  // namespace ui::study
