// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/SharedArch.h"

#include <utility>

#include <QCoreApplication>
#include <QList>
#include <QPointer>
#include <QThreadPool>

namespace ui::render {
namespace {

struct Waiting
{
    QPointer<QObject> owner;
    std::function<void(const ArchPointer&)> done;
};

/// The shared arch and the callers that wait for it. Used by the UI thread only.
struct Shelf
{
    ArchPointer arch;
    bool isBeingMade = false;
    QList<Waiting> waiting;
};

Shelf& shelf()
{
    static Shelf only;
    return only;
}

}  // namespace

void withArch(QObject* owner, std::function<void(const ArchPointer&)> done)
{
    if (shelf().arch) {
        done(shelf().arch);
        return;
    }
    shelf().waiting.push_back({owner, std::move(done)});
    if (std::exchange(shelf().isBeingMade, true))
        return;
    QThreadPool::globalInstance()->start([] {
        const auto arch = std::make_shared<const core::teeth::Arch>();
        QMetaObject::invokeMethod(
            qApp,
            [arch] {
                shelf().arch = arch;
                for (const Waiting& each : std::exchange(shelf().waiting, {}))
                    if (each.owner)
                        each.done(arch);
            },
            Qt::QueuedConnection);
    });
}

}  // namespace ui::render
