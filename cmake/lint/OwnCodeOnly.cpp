// SPDX-License-Identifier: GPL-3.0-or-later
#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>
#include <clang/AST/ASTContext.h>

#include <vector>

namespace {

/// A check of clang-tidy that finds nothing: it takes the headers of Qt, GLM and the standard library from the tree
/// that all other checks walk over. Nobody is shown what they find there, and finding it costs more than half of the
/// time of lint; with precompiled headers (CuspPrecompiled.cmake) it would cost their reading as well.
///
/// The whole unit is the first thing that checks are shown, so what this one leaves decides about all of them.
class OwnCodeOnly : public clang::tidy::ClangTidyCheck
{
public:
    using ClangTidyCheck::ClangTidyCheck;

    void registerMatchers(clang::ast_matchers::MatchFinder* finder) override
    {
        finder->addMatcher(clang::ast_matchers::translationUnitDecl(), this);
    }

    void check(const clang::ast_matchers::MatchFinder::MatchResult& result) override
    {
        clang::ASTContext& context = *result.Context;
        std::vector<clang::Decl*> own;
        for (clang::Decl* declaration : context.getTranslationUnitDecl()->noload_decls())
            if (!declaration->isFromASTFile() &&
                !context.getSourceManager().isInSystemHeader(declaration->getLocation()))
                own.push_back(declaration);
        context.setTraversalScope(own);
    }
};

class CuspModule : public clang::tidy::ClangTidyModule
{
public:
    void addCheckFactories(clang::tidy::ClangTidyCheckFactories& factories) override
    {
        factories.registerCheck<OwnCodeOnly>("cusp-own-code-only");
    }
};

const clang::tidy::ClangTidyModuleRegistry::Add<CuspModule> kRegistered("cusp", "What lint adds to clang-tidy.");

}  // namespace
