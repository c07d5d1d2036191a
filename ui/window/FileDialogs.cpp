// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/FileDialogs.h"

#include <array>

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QList>
#include <QMimeData>
#include <QSaveFile>
#include <QSettings>
#include <QUrl>

#include "lessons/LessonCatalog.h"
#include "lessons/PresetFile.h"
#include "ui/kit/AppSettings.h"
#include "ui/kit/FileDialog.h"
#include "ui/kit/MessageBar.h"
#include "ui/kit/StandardFolders.h"

namespace ui::window {
namespace {

struct FileType
{
    const char* filter;  ///< %1: the patterns, such as *.obj
    const char* folderKey;
    const char* suffix;  ///< null: see scanSuffixes()
};

/// The types of files, in the order of FileDialogs::Kind.
constexpr std::array<FileType, 6> kTypes{{
    {QT_TRANSLATE_NOOP("ui::window::FileDialogs", "Scans of teeth (%1)"), "folders/scan", nullptr},
    {QT_TRANSLATE_NOOP("ui::window::FileDialogs", "Recordings (%1)"), "folders/recording", "cusprec"},
    {QT_TRANSLATE_NOOP("ui::window::FileDialogs", "Pictures (%1)"), "folders/picture", "png"},
    {QT_TRANSLATE_NOOP("ui::window::FileDialogs", "Captured ideals (%1)"), "folders/reference", "cuspideal"},
    {QT_TRANSLATE_NOOP("ui::window::FileDialogs", "Hardness presets (%1)"), "folders/preset", ::lessons::kPresetSuffix},
    {QT_TRANSLATE_NOOP("ui::window::FileDialogs", "Tables (%1)"), "folders/table", "csv"},
}};

const FileType& typeOf(FileDialogs::Kind kind)
{
    return kTypes.at(static_cast<std::size_t>(kind));
}

QString patternsOf(FileDialogs::Kind kind)
{
    QStringList patterns;
    for (const QString& suffix :
         kind == FileDialogs::Kind::Scan ? FileDialogs::scanSuffixes() : QStringList(FileDialogs::suffixOf(kind)))
        patterns << "*." + suffix << "*." + suffix.toUpper();
    return patterns.join(u' ');
}

QString folderOf(FileDialogs::Kind kind)
{
    QString folder = kit::memory().value(QLatin1String(typeOf(kind).folderKey)).toString();
    // Lessons refer to captured ideals in the folder of the lessons.
    if (kind == FileDialogs::Kind::Reference && folder.isEmpty() && QDir().mkpath(::lessons::teachersFolder()))
        folder = ::lessons::teachersFolder();
    return QFileInfo(folder).isDir() ? folder : kit::documentsFolder();
}

}  // namespace

FileDialogs::FileDialogs(QWidget& window, kit::MessageBar& messages)
    : QObject(&window), m_window(window), m_messages(messages)
{}

QString FileDialogs::suffixOf(Kind kind)
{
    return QLatin1String(typeOf(kind).suffix);
}

QString FileDialogs::droppedFile(const QMimeData& data)
{
    const QList<QUrl> urls = data.urls();
    return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

QString FileDialogs::newFileName(const std::string& tooth, Kind kind)
{
    // The colon of "block:line" is not allowed in file names on every system.
    const QString name = QFileInfo(QString::fromStdString(tooth)).completeBaseName().replace(u':', u'-');
    const QString now = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmm"));
    return QStringLiteral("%1-%2.%3").arg(name, now, suffixOf(kind));
}

void FileDialogs::open(const QString& title, Kind kind, const Chosen& chosen)
{
    ask(title, kind, {}, chosen);
}

void FileDialogs::save(const QString& title, Kind kind, const QString& newName, const Chosen& chosen)
{
    ask(title, kind, newName, chosen);
}

void FileDialogs::ask(const QString& title, Kind kind, const QString& newName, const Chosen& chosen)
{
    const QString filter = tr(typeOf(kind).filter).arg(patternsOf(kind));
    auto* dialog = new kit::FileDialog(&m_window, title, folderOf(kind));
    if (newName.isEmpty()) {
        dialog->setFileMode(QFileDialog::ExistingFile);
        dialog->setNameFilters({filter, tr("All files (*)")});
    } else {
        dialog->setAcceptMode(QFileDialog::AcceptSave);
        dialog->setDefaultSuffix(suffixOf(kind));
        dialog->setNameFilter(filter);
        dialog->selectFile(newName);
    }
    connect(dialog, &QFileDialog::fileSelected, this, [kind, chosen](const QString& path) {
        kit::memory().setValue(QLatin1String(typeOf(kind).folderKey), QFileInfo(path).absolutePath());
        chosen(path);
    });
    dialog->open();
}

void FileDialogs::savePicture(const QString& title, const QString& newName, const std::function<QImage()>& picture)
{
    save(title, Kind::Picture, newName, [this, picture](const QString& path) {
        QSaveFile file(path);
        if (file.open(QIODevice::WriteOnly) && picture().save(&file, "PNG") && file.flush() && file.commit())
            showSaved(tr("The picture was saved as %1.").arg(QDir::toNativeSeparators(path)));
        else
            showFailure(tr("The picture could not be written. Choose another folder, or free some disk space."), path,
                        file.errorString());
    });
}

void FileDialogs::saveComparison(const QString& title, const QString& newName, const QByteArray& csv)
{
    save(title, Kind::Table, newName, [this, csv](const QString& path) {
        QSaveFile file(path);
        if (file.open(QIODevice::WriteOnly) && file.write(csv) == csv.size() && file.flush() && file.commit())
            showSaved(tr("The comparison was saved as %1.").arg(QDir::toNativeSeparators(path)));
        else
            showFailure(tr("The comparison could not be written. Choose another folder, or make room on the disk."),
                        path, file.errorString());
    });
}

void FileDialogs::showSaved(const QString& sentence)
{
    m_messages.say({kit::MessageBar::Kind::News, sentence, {}, {}, {}});
}

void FileDialogs::showFailure(const QString& sentence, const QString& path, const QString& technical)
{
    m_messages.say({kit::MessageBar::Kind::Error,
                    sentence,
                    QFileInfo(path).fileName(),
                    {},
                    {},
                    kit::MessageBar::Topic::General,
                    technical});
}

}  // namespace ui::window
