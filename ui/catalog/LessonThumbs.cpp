// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/catalog/LessonThumbs.h"

#include <algorithm>

#include <QImage>
#include <QPainter>

#include "ui/catalog/LessonScene.h"

namespace ui::catalog {
namespace {

constexpr double kThumbGapPx = 6.0;
constexpr double kAboveShare = 0.54;  ///< share of the width for the tooth from above, if there is a section beside it

}  // namespace

LessonThumbs::LessonThumbs(QObject* parent) : QObject(parent)
{
    m_pool.setMaxThreadCount(1);
    m_pool.setThreadPriority(QThread::LowPriority);
}

LessonThumbs::~LessonThumbs()
{
    m_pool.waitForDone();
}

QPixmap LessonThumbs::picture(const ::lessons::Lesson& lesson, const QSize& size, double ratio)
{
    if (!isPictured(lesson))
        return {};
    const QString key = QStringLiteral("%1 %2x%3 %4")
                            .arg(QString::fromStdString(lesson.hash))
                            .arg(size.width())
                            .arg(size.height())
                            .arg(ratio);
    if (const auto made = m_made.constFind(key); made != m_made.constEnd())
        return *made;
    const auto there =
        std::find_if(m_wanted.begin(), m_wanted.end(), [&key](const Wanted& wanted) { return wanted.key == key; });
    if (there != m_wanted.end())
        m_wanted.move(there - m_wanted.begin(), m_wanted.size() - 1);
    else
        m_wanted.append({key, lesson, size, ratio});
    makeNext();
    return {};
}

void LessonThumbs::makeNext()
{
    if (m_isAtWork || m_wanted.isEmpty())
        return;
    m_isAtWork = true;
    // The destructor waits for the pool, so `this` is valid. It also removes queued calls.
    m_pool.start([this, wanted = m_wanted.takeLast()] {
        QImage image;
        if (const auto scene = makeLessonScene(wanted.lesson)) {
            image = QImage(wanted.size * wanted.ratio, QImage::Format_ARGB32_Premultiplied);
            image.setDevicePixelRatio(wanted.ratio);
            image.fill(kPictureGround);
            QPainter painter(&image);
            painter.setRenderHint(QPainter::Antialiasing);
            const QRectF whole({}, QSizeF(wanted.size));
            QRectF above = whole;
            // A lesson about tracing a shape has no section.
            const bool hasSection = scene->plane && wanted.lesson.task != ::lessons::Task::TraceShape;
            if (hasSection)
                above.setWidth(kAboveShare * whole.width());
            const double gap = kThumbGapPx;
            paintFromAbove(painter, inside::areaAround(above.marginsRemoved({gap, gap, gap, gap})), *scene, false);
            if (hasSection)
                inside::paintSmallSection(painter, QRectF(above.topRight(), whole.bottomRight()), sectionOf(*scene));
        }
        QMetaObject::invokeMethod(
            this,
            [this, key = wanted.key, image] {
                m_isAtWork = false;
                m_made.insert(key, QPixmap::fromImage(image));
                emit changed();
                makeNext();
            },
            Qt::QueuedConnection);
    });
}

}  // namespace ui::catalog
