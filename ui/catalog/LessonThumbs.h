// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QList>
#include <QObject>
#include <QPixmap>
#include <QThreadPool>

#include "lessons/Lesson.h"

namespace ui::catalog {

/// Small pictures of lessons, built one by one on another thread when first needed. Ui thread.
class LessonThumbs final : public QObject
{
    Q_OBJECT
public:
    explicit LessonThumbs(QObject* parent);
    ~LessonThumbs() override;

    /// Returns the picture of a lesson. Returns null if the picture cannot be built, or is not built yet; in the latter
    /// case changed() follows. The newest request is served first.
    /// @param size   logical pixels
    /// @param ratio  device pixels per logical pixel
    [[nodiscard]] QPixmap picture(const ::lessons::Lesson& lesson, const QSize& size, double ratio);

signals:
    /// Emitted when a picture has been built.
    void changed();

private:
    struct Wanted
    {
        QString key;
        ::lessons::Lesson lesson;
        QSize size;
        double ratio = 1.0;
    };
    void makeNext();

    QHash<QString, QPixmap> m_made;  ///< null: cannot be built
    QList<Wanted> m_wanted;
    bool m_isAtWork = false;
    QThreadPool m_pool;  ///< last: its destructor waits for a job that uses the members above
};

}  // namespace ui::catalog
