// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/IdleLock.h"

#include <utility>

#include <QCoreApplication>
#include <QEvent>

namespace ui::window {
namespace {

constexpr std::chrono::minutes kUsualLimit{10};
constexpr int kChecksPerLimit = 20;

}  // namespace

IdleLock::IdleLock(Clock clock, QObject* parent) : QObject(parent), m_clock(std::move(clock))
{
    touch();
    connect(&m_timer, &QTimer::timeout, this, &IdleLock::check);
    setLimit(kUsualLimit);
    qApp->installEventFilter(this);
}

void IdleLock::setLimit(std::chrono::milliseconds limit)
{
    m_limit = limit;
    m_timer.start(limit / kChecksPerLimit);
}

void IdleLock::check()
{
    if (m_clock() - m_touchedAt > m_limit)
        emit expired();
}

IdleLock::Clock IdleLock::steadyClock()
{
    return [] {
        return std::chrono::duration_cast<std::chrono::milliseconds>(
            std::chrono::steady_clock::now().time_since_epoch());
    };
}

bool IdleLock::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::Wheel:
    case QEvent::TabletMove:
    case QEvent::TouchUpdate:
        touch();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace ui::window
