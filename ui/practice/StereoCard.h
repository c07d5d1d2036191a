// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "ui/render/Presenter.h"

class QComboBox;
class QLabel;
class QSlider;

namespace ui::practice {

/// Sets up the stereo picture in three steps, each with an instruction and a control: the stereo mode, the distance
/// between the eyes, and the plane of the screen.
class StereoCard : public QFrame
{
    Q_OBJECT
public:
    explicit StereoCard(QWidget* parent);

    /// Opens with these values, and switches stereo on.
    /// @param way  the stereo mode if stereo is off
    void open(const render::Presentation& now, render::Stereo way);
    /// Restores the values from before open(), and closes.
    void cancel();

signals:
    void changed(ui::render::Stereo stereo, double apart, double convergence);
    void done();

private:
    void tell();

    QComboBox* m_mode;
    QSlider* m_apart;
    QSlider* m_convergence;
    render::Presentation m_before;                         ///< settings before open()
    render::Stereo m_wayBefore = render::Stereo::RedCyan;  ///< the stereo mode before open()
};

}  // namespace ui::practice
