// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPushButton>

#include "ui/devices/DeviceKind.h"
#include "ui/devices/NextStep.h"

class QLabel;

namespace ui::devices {

/// Shows the firmware file, with its name if it is known, and a button that chooses another file.
class FirmwareCard : public QFrame
{
    Q_OBJECT
public:
    explicit FirmwareCard(QWidget* parent);

    void setFile(const FirmwareFile& file);
    /// Sets whether choosing a file is the next step of the page.
    void setIsNextStep(bool isNext) { setFilled(*m_choose, isNext); }
    /// Opens the file dialog.
    void choose();

signals:
    void fileChosen(const QString& path);

private:
    void describe();

    FirmwareFile m_file;
    QLabel* m_heading;
    QLabel* m_name;
    QLabel* m_path;
    QLabel* m_fault;
    QPushButton* m_choose;
};

}  // namespace ui::devices
