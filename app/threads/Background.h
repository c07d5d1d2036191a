// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include <QCoreApplication>
#include <QObject>
#include <QPointer>
#include <QThreadPool>

namespace app {

/// Runs `work` on a pool thread and gives its result to `done` on this one, unless `owner` has gone meanwhile.
template <class Work, class Done>
void inBackground(QObject* owner, Work work, Done done)
{
    const QPointer<QObject> guard(owner);
    QThreadPool::globalInstance()->start([guard, work = std::move(work), done = std::move(done)]() mutable {
        auto result = std::make_shared<decltype(work())>(work());
        QMetaObject::invokeMethod(
            qApp,
            [guard, result, done = std::move(done)]() mutable {
                if (guard)
                    done(*result);
            },
            Qt::QueuedConnection);
    });
}

}  // namespace app
