//! What is said of texts, in the words of the protocol.

use super::lines::Lines;
use lsp_types::{
    CodeActionProviderCapability, CompletionItem, CompletionItemKind, CompletionOptions,
    Diagnostic, DiagnosticSeverity, Hover, HoverContents, HoverProviderCapability, MarkupContent,
    MarkupKind, NumberOrString, PositionEncodingKind, SaveOptions, ServerCapabilities,
    TextDocumentSyncCapability, TextDocumentSyncKind, TextDocumentSyncOptions,
    TextDocumentSyncSaveOptions,
};
use torse::editing::{CompletionKind, EditorCompletion, EditorHover, EditorNote, EditorNoteLevel};

/// What the server can do.
pub fn capabilities() -> ServerCapabilities {
    ServerCapabilities {
        position_encoding: Some(PositionEncodingKind::UTF16),
        text_document_sync: Some(TextDocumentSyncCapability::Options(
            TextDocumentSyncOptions {
                open_close: Some(true),
                change: Some(TextDocumentSyncKind::INCREMENTAL),
                save: Some(TextDocumentSyncSaveOptions::SaveOptions(SaveOptions {
                    include_text: Some(false),
                })),
                ..TextDocumentSyncOptions::default()
            },
        )),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        completion_provider: Some(CompletionOptions {
            trigger_characters: Some(["'", "\"", "(", "["].map(str::to_owned).to_vec()),
            ..CompletionOptions::default()
        }),
        code_action_provider: Some(CodeActionProviderCapability::Simple(true)),
        ..ServerCapabilities::default()
    }
}

/// A note as a diagnostic.
pub fn diagnostic(note: &EditorNote, lines: &Lines<'_>) -> Diagnostic {
    let severity = match note.level {
        EditorNoteLevel::Error => DiagnosticSeverity::ERROR,
        EditorNoteLevel::Warning => DiagnosticSeverity::WARNING,
        EditorNoteLevel::Information => DiagnosticSeverity::INFORMATION,
        _ => DiagnosticSeverity::HINT,
    };
    Diagnostic {
        range: lines.range(&note.range),
        severity: Some(severity),
        code: Some(NumberOrString::String(note.rule.to_owned())),
        source: Some("torse".to_owned()),
        message: note.text.clone(),
        ..Diagnostic::default()
    }
}

/// What is said of a place.
pub fn hover(said: EditorHover, lines: &Lines<'_>) -> Hover {
    Hover {
        range: Some(lines.range(&said.range)),
        contents: HoverContents::Markup(MarkupContent {
            kind: MarkupKind::Markdown,
            value: said.markdown,
        }),
    }
}

/// What may stand at a place.
pub fn completion(offer: EditorCompletion) -> CompletionItem {
    let kind = match offer.kind {
        CompletionKind::Function => CompletionItemKind::FUNCTION,
        CompletionKind::Name => CompletionItemKind::VARIABLE,
        CompletionKind::Key => CompletionItemKind::PROPERTY,
        _ => CompletionItemKind::VALUE,
    };
    CompletionItem {
        label: offer.label,
        kind: Some(kind),
        detail: Some(offer.detail).filter(|detail| !detail.is_empty()),
        ..CompletionItem::default()
    }
}
