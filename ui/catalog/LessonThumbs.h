// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QList>
#include <QObject>
#include <QPixmap>
#include <QThreadPool>

#include "lessons/Lesson.h"

namespace ui::catalog {

/// Small pictures of lessons, made one after the other on another thread when they are first seen. Ui thread.
class LessonThumbs final : public QObject
{
    Q_OBJECT
public:
    explicit LessonThumbs(QObject* parent);
    ~LessonThumbs() override;

    /// Null: there is none, or none yet, and changed() follows. What was asked for last is made first.
    /// @param size   px of the page
    /// @param ratio  device pixels for each
    [[nodiscard]] QPixmap picture(const ::lessons::Lesson& lesson, const QSize& size, double ratio);

signals:
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

    QHash<QString, QPixmap> m_made;  ///< null: cannot be made
    QList<Wanted> m_wanted;
    bool m_isAtWork = false;
    QThreadPool m_pool;  ///< last: waited for before what it answers to goes away
};

}  // namespace ui::catalog
