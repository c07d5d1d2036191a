// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>
#include <QTimer>

class QLabel;

namespace ui::kit {

/// Shows the running operation over the middle of the window. Appears after kPatienceMs, so that it does not flash for
/// short operations.
class BusyOverlay : public QFrame
{
    Q_OBJECT
public:
    static constexpr int kPatienceMs = 100;

    explicit BusyOverlay(QWidget* parent);

    void work(const QString& what);
    void done();
    [[nodiscard]] bool isWorking() const { return m_working; }
    void placeIn(const QRect& area);

private:
    QLabel* m_what;
    QTimer m_patience;
    QRect m_area;
    bool m_working = false;
};

}  // namespace ui::kit
