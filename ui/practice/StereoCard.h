// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "ui/render/Presenter.h"

class QComboBox;
class QLabel;
class QSlider;

namespace ui::practice {

/// A small page over the view that sets up the stereo picture in three steps, each with what to look for while one
/// moves a slider: the way to the eyes, their distance, and what lies in the plane of the screen.
class StereoCard : public QFrame
{
    Q_OBJECT
public:
    explicit StereoCard(QWidget* parent);

    /// Shows itself with these values, and the picture in stereo.
    /// @param way  to the eyes, where stereo is off
    void open(const render::Presentation& now, render::Stereo way);
    /// Brings back what was there before it was opened, and closes.
    void cancel();

signals:
    void changed(ui::render::Stereo stereo, double apart, double convergence);
    void done();

private:
    void tell();

    QComboBox* m_mode;
    QSlider* m_apart;
    QSlider* m_convergence;
    render::Presentation m_before;                         ///< when it was opened
    render::Stereo m_wayBefore = render::Stereo::RedCyan;  ///< to the eyes
};

}  // namespace ui::practice
