// A text with emphasised parts.

/** @param text with the parts to emphasise between asterisks, as in words/en.ts */
export function Rich({ text }: { text: string }) {
  return <>{text.split('*').map((part, i) => (i % 2 === 1 ? <strong key={i}>{part}</strong> : part))}</>;
}
