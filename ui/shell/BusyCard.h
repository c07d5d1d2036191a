// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QString>
#include <QTimer>

class QLabel;
class QProgressBar;

namespace ui::shell {

/// What the program is working on, over the middle of the window. Comes only when the work takes a while, so that a
/// quick one does not flash.
class BusyCard : public QFrame
{
    Q_OBJECT
public:
    static constexpr int kPatienceMs = 200;

    explicit BusyCard(QWidget* parent);

    /// @param percent  0 .. 100, or -1 when it cannot be told
    void work(const QString& what, int percent);
    void done();
    [[nodiscard]] bool isWorking() const { return m_working; }
    void placeIn(const QRect& area);

private:
    QLabel* m_what;
    QProgressBar* m_progress;
    QTimer m_patience;
    QRect m_area;
    bool m_working = false;
};

}  // namespace ui::shell
