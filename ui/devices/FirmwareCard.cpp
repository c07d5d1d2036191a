// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/FirmwareCard.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/kit/FileDialog.h"
#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/ValidationTexts.h"

namespace ui::devices {

using namespace ui::kit;

FirmwareCard::FirmwareCard(QWidget* parent)
    : QFrame(parent), m_heading(kit::formWords({}, kSmall, QFont::Medium, QPalette::PlaceholderText, this)),
      m_name(kit::formWords({}, kBody, QFont::Normal, QPalette::WindowText, this)),
      m_path(kit::formWords({}, kSmall, QFont::Normal, QPalette::PlaceholderText, this)),
      m_fault(kit::faultLabel(this)), m_choose(new QPushButton(this))
{
    setProperty("kind", "card");
    setObjectName(QStringLiteral("firmware"));
    m_name->setObjectName(QStringLiteral("firmwareName"));
    m_path->setObjectName(QStringLiteral("firmwarePath"));
    m_fault->setObjectName(QStringLiteral("firmwareFault"));
    m_choose->setObjectName(QStringLiteral("chooseFirmware"));
    m_name->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpace4, kSpace2, kSpace4, kSpace2);
    row->setSpacing(kSpace4);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    for (QLabel* label : {m_heading, m_name, m_path, m_fault})
        words->addWidget(label);
    row->addLayout(words, 1);
    row->addWidget(m_choose, 0, Qt::AlignVCenter);
    connect(m_choose, &QPushButton::clicked, this, &FirmwareCard::choose);
    text::bindTranslation(this, [this] {
        m_heading->setText(tr("Firmware file"));
        m_choose->setText(tr("Choose a file …"));
        m_choose->setAccessibleName(tr("Choose the firmware file"));
        describe();
    });
}

void FirmwareCard::setFile(const FirmwareFile& file)
{
    if (file == m_file)
        return;
    m_file = file;
    describe();
}

void FirmwareCard::describe()
{
    const bool isFirmware = !m_file.sha256.isEmpty();
    m_name->setText(m_file.path.isEmpty()    ? tr("None is chosen.")
                    : !isFirmware            ? QFileInfo(m_file.path).fileName()
                    : !m_file.name.isEmpty() ? m_file.name
                                             //: Of a firmware file; %1: a checksum
                                             : tr("Unknown firmware, SHA-256 %1").arg(m_file.sha256));
    m_name->setToolTip(isFirmware ? QStringLiteral("SHA-256 ") + m_file.sha256 : QString());
    m_path->setText(QDir::toNativeSeparators(m_file.path));
    m_path->setVisible(isFirmware);
    kit::showFault(m_fault,
                   m_file.path.isEmpty() || isFirmware ? QString() : text::faultWords(core::wordsOf(m_file.error)));
}

void FirmwareCard::choose()
{
    const QString folder = m_file.path.isEmpty() ? QDir::homePath() : QFileInfo(m_file.path).absolutePath();
    auto* dialog =
        new FileDialog(this, tr("Choose the firmware file"), folder, tr("Firmware (*.bin *.BIN);;All files (*)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &FirmwareCard::fileChosen);
    dialog->open();
}

}  // namespace ui::devices
