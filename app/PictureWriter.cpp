// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/PictureWriter.h"

#include <utility>

#include <QTimer>

#include "ui/tooth/ToothView.h"

namespace app {
namespace {

constexpr int kLookPeriodMs = 200;
constexpr int kPictureLooks = 5;  ///< looks until the whole tooth has been drawn

}  // namespace

PictureWriter::PictureWriter(ui::window::MainWindow& window, QString path, std::function<bool()> hasTooth)
    : m_window(window), m_path(std::move(path)), m_hasTooth(std::move(hasTooth))
{}

void PictureWriter::start()
{
    QTimer::singleShot(kLookPeriodMs, this, &PictureWriter::look);
}

void PictureWriter::look()
{
    if (m_hasTooth())
        ++m_looks;
    if (m_looks < kPictureLooks)
        start();
    else if (!m_window.view().isUsable())
        emit failed(core::Error{core::ErrorCode::FileUnwritable,
                                "the picture could not be drawn, because this display has no OpenGL 3.3; use "
                                "another display or xvfb-run"});
    else if (!m_window.view().picture().save(m_path))
        emit failed(
            core::Error{core::ErrorCode::FileUnwritable, "the picture could not be written to " + m_path.toStdString() +
                                                             "; check the folder and that the name ends in .png"});
    else
        emit saved();
}

}  // namespace app
