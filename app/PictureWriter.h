// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>
#include <QString>

#include "core/base/Result.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Saves one picture of the tooth when it has been drawn, for the command that draws one and quits. Ui thread.
class PictureWriter final : public QObject
{
    Q_OBJECT

public:
    /// @param window     outlives this
    /// @param path       of the picture, whose name ends in .png
    /// @param hasTooth   whether a tooth, or the end of a recording, is shown
    PictureWriter(ui::window::MainWindow& window, QString path, std::function<bool()> hasTooth);

    void start();

signals:
    /// Emitted when the picture has been written.
    void saved();
    /// Emitted when the picture could not be drawn or written.
    void failed(const core::Error& error);

private:
    void look();

    ui::window::MainWindow& m_window;
    QString m_path;
    std::function<bool()> m_hasTooth;
    int m_looks = 0;
};

}  // namespace app
