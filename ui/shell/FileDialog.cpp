// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/FileDialog.h"

#include <QDir>
#include <QFileIconProvider>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QHeaderView>
#include <QIdentityProxyModel>
#include <QLocale>
#include <QMimeDatabase>
#include <QRegularExpression>
#include <QTreeView>

#include "ui/shell/Memory.h"

namespace ui::shell {
namespace {

constexpr int kSize = 1;  ///< columns of QFileSystemModel
constexpr int kModified = 3;

/// Never opens a file.
class ByName final : public QFileIconProvider
{
public:
    using QFileIconProvider::icon;
    [[nodiscard]] QIcon icon(const QFileInfo& info) const override
    {
        return QFileIconProvider::icon(info.isDir() ? IconType::Folder : IconType::File);
    }
    [[nodiscard]] QString type(const QFileInfo& info) const override
    {
        return info.isDir() ? QString()
                            : QMimeDatabase().mimeTypeForFile(info.fileName(), QMimeDatabase::MatchExtension).comment();
    }
};

/// Qt's own model tells sizes and dates as the computer does, whatever language the program speaks.
class InProgramsLanguage final : public QIdentityProxyModel
{
public:
    using QIdentityProxyModel::QIdentityProxyModel;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override
    {
        const auto* files = qobject_cast<const QFileSystemModel*>(sourceModel());
        if (role == Qt::DisplayRole && files != nullptr) {
            const QModelIndex at = mapToSource(index);
            if (index.column() == kSize && !files->isDir(at))
                return QLocale().formattedDataSize(files->size(at));
            if (index.column() == kModified)
                return QLocale().toString(files->lastModified(at), QLocale::ShortFormat);
        }
        return QIdentityProxyModel::data(index, role);
    }
};

}  // namespace

// It begins to look around at once: where there is no school's file, until it has learned how to look.
FileDialog::FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter)
    : QFileDialog(parent, title, QDir::rootPath(), filter)
{
    static ByName byName;
    setAttribute(Qt::WA_DeleteOnClose);
    setOption(DontUseNativeDialog);  // a desktop's own may look into files, too
    setIconProvider(&byName);
    setProxyModel(new InProgramsLanguage(this));
    setDirectory(folder);
    // Qt makes room for a date as it is written in English.
    if (auto* list = findChild<QTreeView*>(QStringLiteral("treeView")))
        list->header()->setSectionResizeMode(kModified, QHeaderView::ResizeToContents);
    // Without a window manager nobody else gives the keys back.
    if (parent != nullptr)
        connect(this, &QDialog::finished, parent->window(), [window = parent->window()] { window->activateWindow(); });
}

void FileDialog::askWhere(const QString& name, const QString& ending)
{
    static const QRegularExpression kUnfit(QStringLiteral(R"([^\w .,()-]+)"),
                                           QRegularExpression::UseUnicodePropertiesOption);
    const QString key = QStringLiteral("folders/export");
    const QString last = memory().value(key).toString();
    if (QFileInfo(last).isDir())
        setDirectory(last);
    setAcceptMode(AcceptSave);
    setDefaultSuffix(ending);
    selectFile(QString(name).replace(kUnfit, QStringLiteral(" ")).simplified() + u'.' + ending);
    connect(this, &QFileDialog::fileSelected, this,
            [key](const QString& path) { memory().setValue(key, QFileInfo(path).absolutePath()); });
    open();
}

}  // namespace ui::shell
