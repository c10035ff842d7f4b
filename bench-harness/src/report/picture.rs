//! Drawings that suit light and dark: what is black takes the colour of the text, the ground is the page's.

/// `svg`, to stand in a page: named for readers that do not see it, as wide as there is room, without a ground of its
/// own.
pub fn inline(svg: &str, name: &str) -> String {
    let (head, body) = svg.split_once('>').unwrap_or((svg, ""));
    let size = head.split_once("viewBox=\"");
    let size = size.and_then(|(_, rest)| rest.split('"').next());
    let size = size.unwrap_or("0 0 900 540");
    let body = body
        .replace("fill=\"#FFFFFF\"", "fill=\"none\"")
        .replace("#000000", "currentColor")
        .replace("#3C3C3C", "currentColor");
    format!(
        "<svg viewBox=\"{size}\" role=\"img\" aria-label=\"{}\" xmlns=\"http://www.w3.org/2000/svg\">{body}",
        attribute(name)
    )
}

fn attribute(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::inline;

    #[test]
    fn black_becomes_the_text_s_colour_and_white_nothing() {
        let svg = "<svg width=\"9\" height=\"5\" viewBox=\"0 0 9 5\" xmlns=\"x\">\n\
                   <rect fill=\"#FFFFFF\"/><text fill=\"#000000\">a</text></svg>";
        let picture = inline(svg, "a < \"b\"");
        assert!(picture.starts_with("<svg viewBox=\"0 0 9 5\" role=\"img\""));
        assert!(picture.contains("aria-label=\"a &lt; &quot;b&quot;\""));
        assert!(!picture.contains("#000000") && !picture.contains("#FFFFFF"));
    }
}
